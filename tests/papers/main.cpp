// Measures what the papers' figures and claims say, with the library's own functions.
#include <cstdio>

#include <CLI/CLI.hpp>

#include "report.hpp"
#include "whole_file.hpp"

int main(int argc, char** argv)
{
    std::string output = "build/reports/papers_errors.json";
    std::string pictures;
    CLI::App app("The papers' figures as numbers");
    app.add_option("--output", output, "Where the numbers go, as JSON")->capture_default_str();
    app.add_option("--pictures", pictures, "A folder for the pictures");
    CLI11_PARSE(app, argc, argv);

    using namespace lvsm::papers;
    Report report(pictures);
    for (const auto part : {lvsmBleeding, lvsmSeams, lvsmLayers, lvsmPlacement, lvsmStorage, lvsmSamples, esmStep,
                            esmClassification, esmFiltering, evsmProject, vsmArticle})
        part(report);
    const auto problem =
        report.problem() ? report.problem() : lvsm::support::writeWholeFile(output, report.values().dump(1) + '\n');
    if (problem)
        std::fprintf(stderr, "lvsm_papers: %s\n", problem->c_str());
    return problem ? 1 : 0;
}
