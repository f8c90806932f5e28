/// `flipside report` of very little work, for tests that make hundreds of reports: `tiny_report DIR`. Errors
/// end it as they end flipside.

#include "../lab/report/tiny_effort.hpp"
#include "app/cli/exit_code.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/output.hpp"
#include "lab/report/report.hpp"

int main(int argc, char** argv) {
    using namespace flipside;
    app::prepare_streams();
    app::end_on_interrupts();
    return app::exit_code_of([&] {
        lab::report::Effort effort = lab::report::tiny_effort();
        effort.variants = lab::sweep::variants_of({"drop"}, 0);
        lab::report::make_report(
            {argc > 1 ? argv[1] : "report", {}, effort}, [](double) {}, app::say);
        return 0;
    });
}
