// What a pass costs for each unit of its work: bench/costs.json, which the build embeds and `glint bench --costs`
// writes.
#pragma once

#include "lab/tune/work_cost.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::tune {

/// What a pass's work grows with.
struct CostUnit {
    std::string_view name; ///< in the file
    std::string_view meaning;
    double (*amount)(const FrameWork& work); ///< relative to the frame's pixels
    bool isTotal = false;                    ///< counted for the frame as a whole, in however many runs of the pass
};

std::span<const CostUnit> costUnits();

struct CostRow {
    std::string pass; ///< without the ray back end
    const CostUnit* unit = nullptr;
    double floors = 0; ///< for an amount of 1
    std::string note;
};

struct CostTable {
    std::string measured;                ///< where the figures are from
    std::vector<std::string> notCounted; ///< passes that count figures, or run once (measure::effectSum)
    double otherPass = 0;                ///< floors of a pass without a row
    std::vector<CostRow> rows;           ///< a pass may have several; their costs add up

    bool counts(std::string_view pass) const;
    bool hasRow(std::string_view pass) const; ///< True too for a pass that is not counted.
};

/// The table of this build.
const CostTable& costTable();

/// `file` names the text in errors. Errors: InvalidInput for another form, an unknown unit or a cost below 0.
Result<CostTable> readCosts(std::string_view text, std::string_view file);
/// Returns the text that readCosts reads, one row a line.
std::string costsText(const CostTable& table);

/// "rays/reflect_query" and "rays/reflect_bvh" are one pass.
std::string_view withoutBackEnd(std::string_view pass);

/// bench/costs.json; the build makes this function (cmake/embed_text.cmake).
std::string_view embeddedCosts();

} // namespace glint::tune
