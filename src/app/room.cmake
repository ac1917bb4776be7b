target_link_libraries(cleave_app ${scope} CLI11::CLI11)
target_compile_definitions(cleave_app ${scope} CLEAVE_VERSION="${PROJECT_VERSION}")

# The example decks travel inside the program.
file(GLOB example_decks CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/examples/*/*.k)
set(embedded ${CMAKE_BINARY_DIR}/generated/embedded_examples.cpp)
add_custom_command(
  OUTPUT ${embedded}
  COMMAND Python3::Interpreter ${CMAKE_SOURCE_DIR}/cmake/embed_examples.py ${CMAKE_SOURCE_DIR}/examples ${embedded}
  DEPENDS ${CMAKE_SOURCE_DIR}/cmake/embed_examples.py ${example_decks})
target_sources(cleave_app PRIVATE ${embedded})
add_custom_target(generated_examples DEPENDS ${embedded})
add_dependencies(generated generated_examples)
