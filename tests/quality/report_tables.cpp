#include <algorithm>
#include <iomanip>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>

#include "report.hpp"

namespace lvsm::quality
{
namespace
{

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Columns of a table: the layered scenes, each world of meshes averaged over its lights, and the mean of all lights.
class Columns
{
public:
    explicit Columns(const std::vector<Measurement>& measurements)
    {
        for (const Measurement& m : measurements)
        {
            const std::string name = columnOf(m);
            if (std::find(m_names.begin(), m_names.end(), name) == m_names.end())
                m_names.push_back(name);
            m_mesh = m_mesh || m.mesh;
        }
        if (m_mesh)
            m_names.push_back(kMean);
    }

    const std::vector<std::string>& names() const { return m_names; }

    using Row = std::map<std::string, double>;

    Row row(const std::vector<const Measurement*>& measurements) const
    {
        std::map<std::string, std::pair<double, int>> sums;
        const auto add = [&](const std::string& name, double error)
        {
            sums[name].first += error;
            ++sums[name].second;
        };
        for (const Measurement* m : measurements)
        {
            add(columnOf(*m), m->all.rmse);
            if (m->mesh)
                add(kMean, m->all.rmse);
        }
        Row row;
        for (const auto& [name, sum] : sums)
            row[name] = sum.first / sum.second;
        return row;
    }

    /// What techniques are ordered by: the meshes, or the only scenes there are.
    double rank(const Row& row) const
    {
        if (m_mesh)
            return row.at(kMean);
        double sum = 0.0;
        for (const auto& [name, value] : row)
            sum += value;
        return sum;
    }

private:
    static std::string columnOf(const Measurement& m)
    {
        return m.mesh ? m.scene.substr(0, m.scene.find('-')) : m.scene;
    }

    static constexpr const char* kMean = "mesh mean";
    std::vector<std::string> m_names;
    bool m_mesh = false;
};

struct Line
{
    const Measurement* technique;
    Columns::Row row;
    Columns::Row scenes; ///< by the scene's own name
};

void printHeader(const Columns& columns, const std::string& first, std::ostream& out)
{
    out << "\n| " << first << " |";
    for (const std::string& name : columns.names())
        out << ' ' << name << " |";
    out << "\n|---|";
    for (std::size_t i = 0; i < columns.names().size(); ++i)
        out << "---|";
    out << '\n';
}

void printLine(const Columns& columns, const std::string& name, const Columns::Row& row, int digits, std::ostream& out)
{
    out << "| " << name << " |";
    for (const std::string& column : columns.names())
    {
        const auto at = row.find(column);
        out << ' ' << std::fixed << std::setprecision(digits) << (at == row.end() ? kUnknown : at->second) << " |";
    }
    out << '\n';
}

Columns::Row ratio(const Columns::Row& ours, const Columns::Row& peer)
{
    Columns::Row result;
    for (const auto& [name, value] : ours)
    {
        const auto at = peer.find(name);
        if (at != peer.end())
            result[name] = value / std::max(at->second, 1e-9);
    }
    return result;
}

/// How many bits a texel of the shadow map takes at most; 0 for a limit.
int budgetOf(const Measurement& m)
{
    for (const int bits : {0, 8, 16, 32, 64, 128})
    {
        if (m.texelBits() <= bits)
            return bits;
    }
    return 256;
}

/// The best of ours and the best peer among some of the lines.
struct Best
{
    const Line* ours = nullptr;
    const Line* peer = nullptr;

    void consider(const Line& line, const Columns& columns)
    {
        const Line*& best = line.technique->peer ? peer : ours;
        if (best == nullptr || columns.rank(line.row) < columns.rank(best->row))
            best = &line;
    }

    void print(const std::string& what, const Columns& columns, const std::optional<Line>& limit,
               std::ostream& out) const
    {
        if (ours == nullptr || peer == nullptr)
            return;
        std::string worst;
        double most = 0.0;
        std::size_t won = 0;
        for (const auto& [scene, error] : ours->scenes)
        {
            const double others = peer->scenes.at(scene);
            const double against = error / std::max(others, 1e-9);
            won += against < 1.0;
            // To a peer that is as good as exact no ratio means anything.
            if (others > 1e-3 && against > most)
            {
                most = against;
                worst = scene;
            }
        }
        std::ostringstream pair;
        pair << "**" << what << ": " << ours->technique->technique << " / " << peer->technique->technique << "**, won "
             << won << " of " << ours->scenes.size() << ", worst " << worst << ' ' << std::fixed << std::setprecision(2)
             << most;
        printLine(columns, pair.str(), ratio(ours->row, peer->row), 2, out);
        if (!limit)
            return;
        Columns::Row closed;
        for (const auto& [name, error] : peer->row)
        {
            const double gap = error - limit->row.at(name);
            closed[name] = gap > 1e-6 ? (error - ours->row.at(name)) / gap : kUnknown;
        }
        printLine(columns, "share of the gap to the limit that it closes", closed, 2, out);
    }
};

void printWidth(const std::vector<const Measurement*>& measurements, const Columns& columns, std::ostream& out)
{
    std::vector<std::string> order;
    std::map<std::string, std::vector<const Measurement*>> byTechnique;
    for (const Measurement* m : measurements)
    {
        if (byTechnique[m->technique].empty())
            order.push_back(m->technique);
        byTechnique[m->technique].push_back(m);
    }
    std::map<int, std::vector<Line>> byBits;
    for (const std::string& name : order)
    {
        const std::vector<const Measurement*>& rows = byTechnique[name];
        Line line{rows.front(), columns.row(rows), {}};
        for (const Measurement* m : rows)
            line.scenes[m->scene] = m->all.rmse;
        byBits[budgetOf(*rows.front())].push_back(std::move(line));
    }
    std::optional<Line> limit;
    for (const Line& line : byBits[0])
    {
        if (line.technique->technique == "limit: exact, receiver's plane")
            limit = line;
    }
    Best filtered, once, any;
    for (auto& [bits, lines] : byBits)
    {
        std::stable_sort(lines.begin(), lines.end(),
                         [&](const Line& a, const Line& b) { return columns.rank(a.row) < columns.rank(b.row); });
        if (lines.empty())
            continue;
        printHeader(columns, bits > 0 ? std::to_string(bits) + " bits" : "limits", out);
        filtered.ours = once.ours = any.ours = nullptr;
        for (const Line& line : lines)
        {
            printLine(columns, line.technique->technique + (line.technique->peer ? " (peer)" : ""), line.row, 4, out);
            if (bits == 0)
                continue;
            any.consider(line, columns);
            const bool isOnce = line.technique->variant.tapsAcross == 1;
            if (isOnce && line.technique->reading == Reading::Bilinear)
                filtered.consider(line, columns);
            if (isOnce && line.technique->reading != Reading::Window)
                once.consider(line, columns);
        }
        filtered.print("one tap", columns, limit, out);
        once.print("stored, no taps", columns, limit, out);
        any.print("anything", columns, limit, out);
    }
}

} // namespace

void printTables(const Run& run, std::ostream& out)
{
    const Columns columns(run.measurements);
    std::map<std::string, std::vector<const Measurement*>> byTerms;
    std::vector<std::string> order;
    for (const Measurement& m : run.measurements)
    {
        std::string terms = "Width " + std::to_string(m.window.width);
        if (m.footprint.minified())
            terms +=
                ", footprint " + std::to_string(m.footprint.length) + " by 1/" + std::to_string(m.footprint.stretch);
        if (byTerms[terms].empty())
            order.push_back(terms);
        byTerms[terms].push_back(&m);
    }
    out << "RMSE against exact filtered visibility, weighted by n.l; settings chosen in other lights or of another "
           "seed."
           "\nMeshes: mean over the lights. "
        << run.size << " x " << run.size << " texels, seed " << run.seed << ".\n";
    for (const std::string& terms : order)
    {
        out << "\n" << terms << "\n";
        printWidth(byTerms[terms], columns, out);
    }
}

} // namespace lvsm::quality
