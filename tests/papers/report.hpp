// What lvsm_papers measures: named numbers of each item of a paper, and pictures of some. What a paper says of them, and
// by which criterion ours agree, is in the claims*.py beside this file.
#ifndef LVSM_TESTS_PAPERS_REPORT_HPP
#define LVSM_TESTS_PAPERS_REPORT_HPP

#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "panels.hpp"

namespace lvsm::papers
{

class Report
{
public:
    /// pictures: the folder they go to; empty: none are made.
    explicit Report(std::string pictures) : m_pictures(std::move(pictures)) {}

    void add(const std::string& item, const std::string& name, double value) { m_values[item][name] = value; }

    void picture(const std::string& name, const Panels& panels)
    {
        if (!m_pictures.empty() && !m_problem)
            m_problem = panels.write(m_pictures + "/" + name + ".png");
    }

    void fail(const std::string& problem) { m_problem = m_problem ? m_problem : problem; }

    const nlohmann::ordered_json& values() const { return m_values; }
    const std::optional<std::string>& problem() const { return m_problem; }

private:
    std::string m_pictures;
    nlohmann::ordered_json m_values;
    std::optional<std::string> m_problem;
};

// The parts, each a file: they add what they measure.
void lvsmBleeding(Report& report);
void lvsmSeams(Report& report);
void lvsmLayers(Report& report);
void lvsmPlacement(Report& report);
void lvsmStorage(Report& report);
void lvsmSamples(Report& report);
void esmStep(Report& report);
void esmClassification(Report& report);
void esmFiltering(Report& report);
void evsmProject(Report& report);
void vsmArticle(Report& report);

} // namespace lvsm::papers

#endif
