#include "cli/app.h"
#include "runtime/error.h"
#include "runtime/one_line.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

using namespace gnomon;

int run(int argc, char** argv) {
    cli::Common common;
    int exit_code = 0;
    if (argc > 1) cli::require_verb(argv[1]);
    const std::unique_ptr<CLI::App> app = cli::make_app(common, exit_code, argc > 1 ? argv[1] : "");
    try {
        app->parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
            return app->exit(error); // --help
        fmt::print(stderr, "gnomon: {} (gnomon --help, or gnomon VERB --help, shows what there is)\n",
                   one_line(error.what()));
        return 2;
    }
    return exit_code;
}

} // namespace

int main(int argc, char** argv) {
    // Buffers of a few MiB come and go with every kernel: keep their pages instead of faulting them in anew
    // each time.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    int exit_code = 2;
    try {
        exit_code = run(argc, argv);
    } catch (const gnomon::CompileError& error) { // a line for each of the compiler's
        fmt::print(stderr, "gnomon: {}\n", error.what());
    } catch (const gnomon::Error& error) { // may quote what users gave
        fmt::print(stderr, "gnomon: {}\n", one_line(error.what()));
    } catch (const std::bad_alloc&) {
        fmt::print(
            stderr,
            "gnomon: not enough memory; make the image or shadow map smaller, or take fewer samples\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "gnomon: unexpected: {}\n", error.what());
    }
    // Everything that matters is written. Leaving without destructors spares the driver's slow farewell, and
    // is the only way out while a kernel loops for ever in one of its threads.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        fmt::print(stderr, "gnomon: standard output could not be written to its end\n");
        exit_code = 2;
    }
    std::fflush(nullptr);
    std::_Exit(exit_code);
}
