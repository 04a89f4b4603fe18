// Techniques as the papers have them, beside those of tests/quality.
#ifndef LVSM_TESTS_PAPERS_TECHNIQUES_OF_PAPERS_HPP
#define LVSM_TESTS_PAPERS_TECHNIQUES_OF_PAPERS_HPP

#include "panels.hpp"
#include "scenes.hpp"
#include "stored_map.hpp"

namespace lvsm::papers
{

/// LVSM as in the paper: one layer judges, and near a split two are blended. One layer is a variance shadow map.
/// splits: from 0 to 1. overlap: of the layers; width: of the transition; both in depth.
struct Layering
{
    std::vector<float> splits{0.0f, 1.0f};
    quality::Format format = quality::Format::Fp32;
    float overlap = 0.0f;
    float width = 0.0f;
    bool least = false; ///< the least bound of the receiver's layer and all in front, at a sample for each

    int count() const { return static_cast<int>(splits.size()) - 1; }
};

quality::Technique layered(const Layering& layering);

std::vector<float> uniformSplits(int count);

/// By the paper's relaxation, of what the map sees.
std::vector<float> relaxedSplits(const quality::Scene& scene, int count);

/// Depths of the map, row by row.
std::vector<float> mapDepths(const quality::Scene& scene);

using quality::techniqueNamed;

/// What a technique makes of every receiver of a view, each pass of its filter rounded to its format.
std::vector<float> visibilities(const Lit& lit, const quality::Technique& technique);
std::vector<float> truths(const View& view);

/// Errors over all receivers, and how much of them bleeds where no light is.
struct ViewErrors
{
    double rmse = 0.0;
    double bleed = 0.0;    ///< mean visibility of what is in full shadow
    double worst = 0.0;    ///< largest of the same
    double dark = 0.0;     ///< mean loss of what is fully lit
    double darkest = 0.0;  ///< largest of the same
    double penumbra = 0.0; ///< RMSE of the others
    double contact = 0.0;  ///< mean visibility of what is in full shadow of a surface less than 0.03 in front
    double shielded = 0.0; ///< largest visibility behind the shield
};
ViewErrors errorsOf(const View& view, const std::vector<float>& visibility);

/// Shaded by the visibilities, into one panel; with splits, in the colours of the layers.
void shade(Panels& panels, int panel, const View& view, const std::vector<float>& visibility,
           const std::vector<float>& splits = {});

/// Panels as large as a view.
Panels panelsOf(const View& view, int count);

} // namespace lvsm::papers

#endif
