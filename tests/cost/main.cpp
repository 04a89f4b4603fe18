// lvsm_cost: what each shader function and each whole visibility estimate costs on AMD GPUs, told by Mesa's compiler.
#include "kernels.hpp"
#include "radv.hpp"

#include <shader_compiler.hpp>
#include <whole_file.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

namespace
{

using cost::Kernel;
using cost::Radv;
using cost::Statistics;
using nlohmann::json;

constexpr int kSkipped = 77;
constexpr double kAllowedGrowth = 1.03;

struct Options
{
    std::vector<std::string> targets = {"GFX1100", "NAVI21", "POLARIS10"};
    std::string glslFolder;
    std::string report;
    std::string recorded;
    bool record = false;
};

// A kernel's cost, and that of the one beside it.
struct Cost
{
    std::string target;
    const Kernel* kernel;
    Statistics whole;
    Statistics beside;

    Statistics net() const
    {
        const Statistics loads = kernel->kind == "function" || kernel->kind == "form" ? beside : Statistics{0, 0, 0};
        return {whole.instructions - loads.instructions, whole.inverseThroughput - loads.inverseThroughput,
                whole.registers};
    }
};

[[noreturn]] void fail(const std::string& message)
{
    std::fprintf(stderr, "lvsm_cost: %s\n", message.c_str());
    std::exit(1);
}

struct Compiled
{
    Kernel kernel;
    std::vector<std::uint32_t> whole;
    std::vector<std::uint32_t> beside;
};

std::vector<std::uint32_t> compile(const std::string& name, const std::string& text, const Options& options)
{
    if (text.empty())
        return {};
    lvsm::support::ShaderOptions shader;
    shader.name = name;
    shader.includeFolders = {options.glslFolder, options.glslFolder + "/lvsm/passes"};
    const auto spirv = lvsm::support::compileShader(text, shader);
    if (!spirv)
        fail(name + ":\n" + spirv.error());
    return *spirv;
}

Statistics statistics(const Radv& radv, const std::string& name, const std::vector<std::uint32_t>& spirv)
{
    if (spirv.empty())
        return {0, 0, 0};
    const auto result = radv.compile(spirv);
    if (!result)
        fail(name + ": " + result.error());
    return *result;
}

// What a map costs for each texel of the shadow map: its passes added up.
json mapRow(const cost::Map& map, const std::string& target, const json& rows)
{
    const std::string resolution = map.resolution < 1.0 ? " half" : "";
    json row = {{"kind", "map"},
                {"target", target},
                {"name", "map " + map.name + ' ' + std::to_string(map.width) + resolution},
                {"map", map.name},
                {"width", map.width},
                {"resolution", map.resolution},
                {"bits", map.bits},
                {"slice", map.slice}};
    const char* const figures[] = {"instructions", "inverse_throughput", "read_bytes", "written_bytes"};
    for (const char* figure : figures)
        row[figure] = 0.0;
    for (const auto& [name, times] : map.passes)
    {
        const auto pass =
            std::find_if(rows.begin(), rows.end(),
                         [&, name = name](const json& r) { return r.at("target") == target && r.at("name") == name; });
        if (pass == rows.end())
            fail("there is no pass " + name + ", which makes " + map.name);
        for (const char* figure : figures)
            row[figure] = row[figure].get<double>() + times * pass->at(figure).get<double>();
    }
    return row;
}

json rowsOf(const std::vector<Cost>& costs)
{
    json rows = json::array();
    for (const Cost& cost : costs)
    {
        const Kernel& kernel = *cost.kernel;
        const Statistics net = cost.net();
        json row = {{"kind", kernel.kind},
                    {"target", cost.target},
                    {"name", kernel.name},
                    {"instructions", net.instructions},
                    {"inverse_throughput", net.inverseThroughput},
                    {"registers", net.registers}};
        if (kernel.kind == "estimate")
            row.update({{"map", kernel.map}, {"decisions", kernel.decisions}});
        if (kernel.kind == "estimate" && !kernel.beside.empty())
            row["wrapper_inverse_throughput"] = cost.beside.inverseThroughput;
        if (kernel.kind == "pass")
            row.update({{"read_bytes", kernel.readBytes}, {"written_bytes", kernel.writtenBytes}});
        rows.push_back(row);
    }
    std::set<std::string> targets;
    for (const Cost& cost : costs)
        targets.insert(cost.target);
    for (const std::string& target : targets)
    {
        for (const cost::Map& map : cost::maps())
            rows.push_back(mapRow(map, target, rows));
    }
    return rows;
}

void write(const std::string& path, const std::string& text)
{
    if (const auto problem = lvsm::support::writeWholeFile(path, text))
        fail(*problem);
}

json readRecorded(const std::string& path)
{
    json recorded = json::parse(std::ifstream(path), nullptr, false);
    if (recorded.is_discarded() || !recorded.contains("compiler") || !recorded.contains("rows"))
        fail("cannot read " + path);
    return recorded;
}

// What is recorded already, to which figures of this compiler can be added; empty where there is no file.
json readToAddTo(const std::string& path, const std::string& version)
{
    if (!std::filesystem::exists(path))
        return {{"rows", json::array()}};
    const json recorded = readRecorded(path);
    if (recorded.at("compiler") != version)
        fail(path + " holds " + std::to_string(recorded.at("rows").size()) + " figures of " +
             recorded.at("compiler").get<std::string>() + ", which do not compare with those of " + version +
             ": nothing is recorded. Record with the Mesa of packages.txt's Debian; to change over to this one, "
             "remove the file first, and say so in docs/cost.md.");
    return recorded;
}

// Records the costs in place of those of the same targets. What is recorded for others stays, as far as there still is
// such a function, and so it must come from the same compiler.
void record(const std::string& version, const std::vector<Cost>& costs, const Options& options)
{
    json rows = rowsOf(costs);
    std::set<std::string> names;
    for (const json& row : rows)
        names.insert(row.at("name").get<std::string>());
    const auto& targets = options.targets;
    const json recorded = readToAddTo(options.recorded, version);
    for (const json& row : recorded.at("rows"))
    {
        if (std::find(targets.begin(), targets.end(), row.at("target")) == targets.end() &&
            names.count(row.at("name")) > 0)
            rows.push_back(row);
    }
    const std::vector<std::string> order = Options().targets;
    std::stable_sort(rows.begin(), rows.end(),
                     [&order](const json& a, const json& b)
                     {
                         return std::find(order.begin(), order.end(), a.at("target")) <
                                std::find(order.begin(), order.end(), b.at("target"));
                     });
    // One row a line, so that a change of one function is a change of one line for each target.
    std::string text = "{\n\"compiler\": " + json(version).dump() + ",\n\"rows\": [\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
        text += rows[i].dump() + (i + 1 < rows.size() ? ",\n" : "\n");
    write(options.recorded, text + "]\n}\n");
}

// How many differences are failures: what has grown, what is not recorded, what is recorded but gone.
int compareWithRecorded(const json& recorded, const std::vector<Cost>& costs)
{
    std::map<std::pair<std::string, std::string>, json> before;
    for (const json& row : recorded.at("rows"))
        before[{row.at("target"), row.at("name")}] = row;
    int failures = 0;
    for (const json& row : rowsOf(costs))
    {
        const std::string target = row.at("target");
        const std::string name = row.at("name");
        const auto found = before.find({target, name});
        if (found == before.end())
        {
            std::printf("FAIL %s on %s is not recorded\n", name.c_str(), target.c_str());
            ++failures;
            continue;
        }
        for (const char* figure : {"instructions", "inverse_throughput"})
        {
            const double was = found->second.at(figure);
            const double is = row.at(figure);
            const bool grown = is > was && is > was * kAllowedGrowth;
            failures += grown ? 1 : 0;
            if (is != was)
                std::printf("%s %s on %s: %g %s, recorded %g\n", grown ? "FAIL" : "note", name.c_str(), target.c_str(),
                            is, figure, was);
        }
        before.erase(found);
    }
    for (const auto& [key, row] : before)
    {
        std::printf("FAIL %s on %s is recorded, but there is no such function\n", key.second.c_str(),
                    key.first.c_str());
        ++failures;
    }
    return failures;
}

void printTable(const std::vector<Cost>& costs, const Options& options)
{
    std::printf("instructions, inverse throughput; the loads taken off\n%-28s", "");
    for (const std::string& target : options.targets)
        std::printf(" %13s", target.c_str());
    std::printf("\n");
    const std::size_t count = costs.size() / options.targets.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        std::printf("%-28s", costs[i].kernel->name.c_str());
        for (std::size_t t = 0; t < options.targets.size(); ++t)
        {
            const Statistics net = costs[t * count + i].net();
            std::printf(" %6d %6d", net.instructions, net.inverseThroughput);
        }
        std::printf("\n");
    }
}

// 0, or 1 where something has grown, or the status of a skip.
int check(const std::string& version, const std::vector<Cost>& costs, const Options& options)
{
    const json recorded = readRecorded(options.recorded);
    if (recorded.at("compiler") != version)
    {
        std::printf("skip: the figures recorded are those of %s, and this is %s\n",
                    recorded.at("compiler").get<std::string>().c_str(), version.c_str());
        return kSkipped;
    }
    const int failures = compareWithRecorded(recorded, costs);
    if (failures > 0)
        std::printf("%d failures. If they are meant, record them and commit that with the change:\n"
                    "build/tests/cost/lvsm_cost --glsl glsl --recorded tests/cost/recorded.json --record\n",
                    failures);
    return failures > 0 ? 1 : 0;
}

int measure(const Options& options)
{
    // What cannot be recorded is refused before it is measured.
    if (options.record)
    {
        const auto radv = Radv::open(options.targets.front());
        if (radv)
            readToAddTo(options.recorded, radv->version());
    }
    std::vector<Compiled> kernels;
    for (const std::vector<Kernel>& list :
         {cost::estimateKernels(options.glslFolder), cost::passKernels(options.glslFolder),
          cost::formKernels(options.glslFolder), cost::functionKernels()})
    {
        for (const Kernel& kernel : list)
            kernels.push_back({kernel, compile(kernel.name, kernel.text, options),
                               compile(kernel.name + " (beside)", kernel.beside, options)});
    }

    std::vector<Cost> costs;
    std::string version;
    for (const std::string& target : options.targets)
    {
        const auto radv = Radv::open(target);
        if (!radv)
        {
            std::printf("skip: %s\n", radv.error().c_str());
            return kSkipped;
        }
        version = radv->version();
        for (const Compiled& kernel : kernels)
            costs.push_back({target, &kernel.kernel, statistics(*radv, kernel.kernel.name, kernel.whole),
                             statistics(*radv, kernel.kernel.name + " (beside)", kernel.beside)});
    }
    printTable(costs, options);
    if (!options.report.empty())
        write(options.report, rowsOf(costs).dump(1) + '\n');
    if (options.record)
        record(version, costs, options);
    return options.recorded.empty() || options.record ? 0 : check(version, costs, options);
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app("Tells what the shader functions cost on AMD GPUs, by Mesa's compiler, without a GPU.");
    app.add_option("--glsl", options.glslFolder, "folder that holds lvsm/lvsm.glsl")->required();
    app.add_option("--targets", options.targets, "families of GPUs, as RADV_FORCE_FAMILY takes them");
    app.add_option("--report", options.report, "JSON file to write");
    CLI::Option* recorded =
        app.add_option("--recorded", options.recorded, "fail where a figure is more than 3% above this file's");
    app.add_flag("--record", options.record, "write the figures into the file of --recorded instead")->needs(recorded);
    CLI11_PARSE(app, argc, argv);
    return measure(options);
}
