# The card table: data/cards.json becomes constant tables at build time.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(card_table ${CMAKE_BINARY_DIR}/generated/deck/card_table.inc)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/generated/deck)
add_custom_command(
  OUTPUT ${card_table}
  COMMAND Python3::Interpreter ${CMAKE_SOURCE_DIR}/cmake/card_table.py ${CMAKE_SOURCE_DIR}/data/cards.json ${card_table}
  DEPENDS ${CMAKE_SOURCE_DIR}/cmake/card_table.py ${CMAKE_SOURCE_DIR}/data/cards.json
  COMMENT "Writing the card table"
  VERBATIM)
target_sources(cleave_deck PRIVATE ${card_table})
add_custom_target(generated_card_table DEPENDS ${card_table})
add_dependencies(generated generated_card_table)
