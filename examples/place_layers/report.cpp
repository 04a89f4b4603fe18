#include "report.hpp"

#include <cstdarg>
#include <cstdio>
#include <functional>
#include <map>

#include <nlohmann/json.hpp>

namespace lvsm::place_layers
{
namespace
{

std::string text(const char* pattern, ...)
{
    char buffer[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
    va_end(arguments);
    return buffer;
}

// As many digits as tell floats apart, and never a whole number, which GLSL ES would not take for a float.
std::string number(float value)
{
    const std::string digits = text("%.9g", static_cast<double>(value));
    return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string list(const std::vector<float>& values, const char* suffix)
{
    std::string joined;
    for (const float value : values)
        joined += (joined.empty() ? "" : ", ") + number(value) + suffix;
    return joined;
}

// Comments end with their line: a file's name must not.
std::string oneLine(std::string name)
{
    for (char& c : name)
        c = c == '\n' || c == '\r' || c == '\\' ? '_' : c;
    return name;
}

std::string inWords(const Report& report)
{
    const Image& image = report.depths.image;
    std::string out = text("%d x %d pixels, linear depths from %.6g to %.6g\n", image.width, image.height,
                           static_cast<double>(report.depths.least), static_cast<double>(report.depths.most));
    out += text("predicted error of visibility (root mean square, windows of %d x %d pixels):\n", kWindow, kWindow);
    out += "  method    layered  bracketed\n";
    for (const Placement& placement : report.placements)
    {
        out += text("  %-8s", placement.method.c_str());
        out += placement.splits.empty() ? "        -" : text("%9.4f", placement.errors.layered);
        const bool isBracketed = !placement.splits.empty() && placement.errors.bracketed;
        out += isBracketed ? text("%11.4f", *placement.errors.bracketed) : "          -";
        out += &placement == &report.chosen ? "  <\n" : "\n";
    }
    const std::vector<float>& splits = report.chosen.splits;
    for (std::size_t i = 0; i + 1 < splits.size(); ++i)
        out += text("layer %zu: depth %.6f to %.6f\n", i, static_cast<double>(splits[i]),
                    static_cast<double>(splits[i + 1]));
    return out;
}

std::string asJson(const Report& report)
{
    nlohmann::ordered_json errors;
    for (const Placement& placement : report.placements)
    {
        if (placement.splits.empty())
            continue;
        errors[placement.method] = {{"layered", placement.errors.layered}};
        if (placement.errors.bracketed)
            errors[placement.method]["bracketed"] = *placement.errors.bracketed;
    }
    const nlohmann::ordered_json json{{"image", report.path},
                                      {"width", report.depths.image.width},
                                      {"height", report.depths.image.height},
                                      {"ignored", report.depths.ignored},
                                      {"method", report.chosen.method},
                                      {"layers", report.task.layerCount},
                                      {"overlap", report.task.overlap},
                                      {"splits", report.chosen.splits},
                                      {"errors", errors}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string heading(const Report& report)
{
    return "// Of " + oneLine(report.path) + ", by the method " + report.chosen.method + ".\n";
}

std::string asGlsl(const Report& report)
{
    const std::string size = std::to_string(report.chosen.splits.size());
    return heading(report) + "// For lvsm_layerIndex define LVSM_MAX_LAYERS as " +
           std::to_string(report.task.layerCount) + " before lvsm is included.\n" +
           "const int kLayerCount = " + std::to_string(report.task.layerCount) +
           ";\nconst float kOverlap = " + number(report.task.overlap) + ";\nconst float kSplits[" + size +
           "] = float[" + size + "](" + list(report.chosen.splits, "") + ");\n";
}

std::string asHlsl(const Report& report)
{
    return heading(report) + "// For lvsm_layerIndex define LVSM_MAX_LAYERS as " +
           std::to_string(report.task.layerCount) + " before lvsm is included.\n" +
           "static const int kLayerCount = " + std::to_string(report.task.layerCount) +
           ";\nstatic const float kOverlap = " + number(report.task.overlap) + ";\nstatic const float kSplits[" +
           std::to_string(report.chosen.splits.size()) + "] = {" + list(report.chosen.splits, "") + "};\n";
}

std::string asCpp(const Report& report)
{
    return heading(report) + "constexpr int kLayerCount = " + std::to_string(report.task.layerCount) +
           ";\nconstexpr float kOverlap = " + number(report.task.overlap) + "f;\nconstexpr float kSplits[" +
           std::to_string(report.chosen.splits.size()) + "] = {" + list(report.chosen.splits, "f") + "};\n";
}

const std::map<std::string, std::function<std::string(const Report&)>>& formats()
{
    static const std::map<std::string, std::function<std::string(const Report&)>> all{
        {"text", inWords}, {"json", asJson}, {"glsl", asGlsl}, {"hlsl", asHlsl}, {"cpp", asCpp}};
    return all;
}

} // namespace

std::vector<std::string> formatNames()
{
    std::vector<std::string> names;
    for (const auto& [name, write] : formats())
        names.push_back(name);
    return names;
}

std::string format(const Report& report, const std::string& name)
{
    return formats().at(name)(report);
}

} // namespace lvsm::place_layers
