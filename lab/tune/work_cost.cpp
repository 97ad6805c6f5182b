#include "lab/tune/work_cost.hpp"

#include "lab/tune/cost_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string_view>

namespace glint::tune {

static size_t hundredthsOf(float perceptualRoughness) {
    return static_cast<size_t>(std::lround(100 * std::clamp(perceptualRoughness, 0.0f, 1.0f)));
}

void RoughShare::add(float perceptualRoughness, double share) {
    shares_[hundredthsOf(perceptualRoughness)] += share;
}

void RoughShare::add(const RoughShare& other, double part) {
    for (size_t i = 0; i < shares_.size(); ++i)
        shares_[i] += part * other.shares_[i];
}

double RoughShare::upTo(float perceptualRoughness) const {
    const auto end = shares_.begin() + static_cast<ptrdiff_t>(hundredthsOf(perceptualRoughness)) + 1;
    return std::accumulate(shares_.begin(), end, 0.0);
}

double countedFloors(const FrameWork& work) {
    const CostTable& table = costTable();
    double floors = 0;
    for (size_t i = 0; i < work.passes.size(); ++i) {
        const std::string_view pass = work.passes[i];
        if (!table.counts(pass))
            continue;
        const std::span earlier(work.passes.data(), i);
        const bool again = std::ranges::find(earlier, pass) != earlier.end();
        bool known = false;
        for (const CostRow& row : table.rows) {
            if (row.pass != withoutBackEnd(pass))
                continue;
            floors += again && row.unit->isTotal ? 0 : row.floors * row.unit->amount(work);
            known = true;
        }
        floors += known ? 0 : table.otherPass;
    }
    return floors;
}

} // namespace glint::tune
