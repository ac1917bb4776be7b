#include <cstdio>
#include <exception>

#include "app/commands.hpp"

int main(int argc, char** argv) {
  using namespace cleave::app;
  Options options;
  if (const int status = parse(argc, argv, options); status >= 0) return status;
  try {
    switch (options.command) {
      case Command::run:
        return run(options);
      case Command::restart:
        return restart(options);
      case Command::check:
        return check(options);
      case Command::view:
        return view(options);
      case Command::explain:
        return explain(options);
      case Command::convert:
        return convert(options);
      case Command::examples:
        return examples(options);
      case Command::none:
        break;
    }
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "cleave: not enough memory for this model\n");
    return internal_error;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cleave: %s\n", error.what());
    return internal_error;
  }
  return bad_usage;
}
