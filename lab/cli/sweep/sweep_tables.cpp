#include "lab/cli/sweep/sweep_tables.hpp"

#include "base/file.hpp"
#include "lab/cli/report/page_template.hpp"
#include "lab/measure/figures/figure_change.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace glint::cli {
namespace {

constexpr const char* kTableFormat = "glint sweep table 1";

/// The jobs that differ in their seed alone, in the order of the first ones.
std::vector<std::vector<const SweepRow*>> seedGroups(const SweepTables& tables) {
    std::map<std::string, size_t> places;
    std::vector<std::vector<const SweepRow*>> groups;
    for (const SweepRow& row : tables.rows) {
        if (!row.result)
            continue;
        SweepJson key = row.description;
        key.erase("name");
        key.erase("seed");
        const auto [found, added] =
            places.try_emplace(key.dump(-1, ' ', false, SweepJson::error_handler_t::replace), groups.size());
        if (added)
            groups.emplace_back();
        groups[found->second].push_back(&row);
    }
    return groups;
}

/// The values of a figure in those rows that have it.
std::vector<double> valuesOf(const std::vector<const SweepRow*>& rows, const std::string& figure) {
    std::vector<double> values;
    for (const SweepRow* row : rows)
        if (row->result->figures.contains(figure))
            values.push_back(row->result->figures[figure].get<double>());
    return values;
}

SweepJson meanJson(const std::vector<const SweepRow*>& rows, const std::vector<std::string>& figures) {
    const SweepRow& first = *rows.front();
    SweepJson json = {{"kind", first.description["kind"]},     {"scene", first.description["scene"]},
                      {"width", first.result->width},          {"height", first.result->height},
                      {"config", first.description["config"]}, {"seeds", rows.size()},
                      {"figures", SweepJson::object()}};
    for (const std::string& figure : figures) {
        const std::vector<double> values = valuesOf(rows, figure);
        if (values.size() >= 2) {
            const measure::Estimate estimate = measure::Estimate::of(values);
            json["figures"][figure] = {{"mean", estimate.value}, {"standardError", estimate.standardError}};
        } else if (!values.empty()) {
            json["figures"][figure] = {{"mean", values.front()}, {"standardError", nullptr}};
        }
    }
    return json;
}

/// RFC 4180: in quotes where it has a comma, a quote or a line break.
std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string csvLine(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& cell : cells)
        line += (&cell == &cells.front() ? "" : ",") + csvCell(cell);
    return line + "\r\n";
}

std::string numberAt(const SweepJson& json, const char* key) {
    return json.contains(key) && json[key].is_number() ? json[key].dump() : std::string();
}

std::string deviceText(const SweepResult& result) {
    return fmt::format("{}, {}", result.device, result.driver);
}

} // namespace

size_t SweepTables::missing() const {
    return static_cast<size_t>(std::ranges::count_if(rows, [](const SweepRow& row) { return !row.result; }));
}

std::vector<std::string> SweepTables::devices() const {
    std::set<std::string> names;
    for (const SweepRow& row : rows)
        if (row.result)
            names.insert(deviceText(*row.result));
    return {names.begin(), names.end()};
}

Result<SweepTables> readSweepTables(const SweepFolder& folder) {
    GLINT_TRY(list, folder.readList());
    SweepTables tables = {std::move(list.program), std::move(list.plan), {}, {}};
    std::set<std::string> figures;
    for (SweepJson& description : list.jobs) {
        SweepRow row;
        row.result = folder.readResult(description);
        if (!row.result)
            row.failure = folder.readFailure(description["name"].get<std::string>());
        else
            for (const auto& [name, value] : row.result->figures.items())
                figures.insert(name);
        row.description = std::move(description);
        tables.rows.push_back(std::move(row));
    }
    tables.figureNames.assign(figures.begin(), figures.end());
    return tables;
}

SweepJson sweepTableJson(const SweepTables& tables) {
    SweepJson json = {{"format", kTableFormat},     {"program", tables.program},     {"devices", tables.devices()},
                      {"jobs", tables.rows.size()}, {"missing", SweepJson::array()}, {"rows", SweepJson::array()},
                      {"means", SweepJson::array()}};
    for (const SweepRow& row : tables.rows) {
        if (!row.result) {
            json["missing"].push_back(row.description["name"]);
            continue;
        }
        json["rows"].push_back({{"job", row.description["name"]},
                                {"kind", row.description["kind"]},
                                {"scene", row.description["scene"]},
                                {"width", row.result->width},
                                {"height", row.result->height},
                                {"config", row.description["config"]},
                                {"seed", row.description["seed"]},
                                {"figures", row.result->figures}});
    }
    for (const std::vector<const SweepRow*>& group : seedGroups(tables))
        json["means"].push_back(meanJson(group, tables.figureNames));
    return json;
}

std::string sweepTableCsv(const SweepTables& tables) {
    std::vector<std::string> cells = {"job", "kind", "scene", "width", "height", "config", "seed"};
    cells.insert(cells.end(), tables.figureNames.begin(), tables.figureNames.end());
    std::string text = csvLine(cells);
    for (const SweepRow& row : tables.rows) {
        if (!row.result)
            continue;
        const SweepJson& job = row.description;
        cells = {job["name"].get<std::string>(),
                 job["kind"].get<std::string>(),
                 job["scene"].get<std::string>(),
                 fmt::format("{}", row.result->width),
                 fmt::format("{}", row.result->height),
                 job["config"].get<std::string>(),
                 job["seed"].dump()};
        for (const std::string& figure : tables.figureNames)
            cells.push_back(numberAt(row.result->figures, figure.c_str()));
        text += csvLine(cells);
    }
    return text;
}

std::string sweepTimesCsv(const SweepTables& tables) {
    std::string text = csvLine({"job", "host", "device", "seconds", "effectMs", "effectMs95", "floorMs", "floors"});
    for (const SweepRow& row : tables.rows) {
        if (!row.result)
            continue;
        const SweepJson& run = row.result->run;
        std::vector<std::string> cells = {
            row.description["name"].get<std::string>(),
            run.contains("host") && run["host"].is_string() ? run["host"].get<std::string>() : std::string(),
            deviceText(*row.result)};
        for (const char* key : {"seconds", "effectMs", "effectMs95", "floorMs", "floors"})
            cells.push_back(numberAt(run, key));
        text += csvLine(cells);
    }
    return text;
}

std::string sweepPage(const SweepJson& table, const std::string& plan) {
    SweepJson json = table;
    json.erase("rows"); // the page shows the means; table.csv has the rows
    json["plan"] = plan;
    return filledPage(sweepPageParts(), "Glint sweep: " + plan, scriptJson(json));
}

Result<void> writeSweepTables(const SweepFolder& folder, const SweepTables& tables) {
    const SweepJson json = sweepTableJson(tables);
    GLINT_CHECK(
        writeFile(folder.path() + "/table.json", json.dump(1, ' ', false, SweepJson::error_handler_t::replace) + "\n"));
    GLINT_CHECK(writeFile(folder.path() + "/table.csv", sweepTableCsv(tables)));
    GLINT_CHECK(writeFile(folder.path() + "/times.csv", sweepTimesCsv(tables)));
    return writeFile(folder.path() + "/index.html", sweepPage(json, tables.plan));
}

} // namespace glint::cli
