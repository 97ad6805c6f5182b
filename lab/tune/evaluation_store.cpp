#include "lab/tune/evaluation_store.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/tune/search_space.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace glint::tune {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kLongestStore = size_t{1} << 28; // bytes: a hundred thousand evaluations of ten views
constexpr const char* kFormat = "glint tune 1";

std::string keyOf(const Settings& start, const Settings& settings) {
    return joinText(differences(start, settings), "\n");
}

const char* setName(ViewSet set) {
    return set == ViewSet::Search ? "search" : "held";
}

Json evaluationJson(ViewSet set, const std::string& key, const Evaluation& evaluation) {
    Json views = Json::array();
    for (const ViewFigures& view : evaluation.views)
        views.push_back({view.view, view.figures.cost,
                         std::isfinite(view.figures.error) ? Json(view.figures.error) : Json(nullptr)});
    Json json = {{"set", setName(set)}, {"settings", key}, {"views", std::move(views)}};
    if (evaluation.views.empty())
        json["limit"] = evaluation.limit;
    return json;
}

/// Reads one view's figures. Throws Json::exception for another type.
ViewFigures readView(const Json& json) {
    const double error = json.at(2).is_null() ? kInfinite : json.at(2).get<double>();
    return {json.at(0).get<std::string>(), {json.at(1).get<double>(), error}};
}

/// Throws Json::exception for another form.
Evaluation readEvaluation(const Json& json) {
    Evaluation evaluation;
    for (const Json& view : json.at("views"))
        evaluation.views.push_back(readView(view));
    if (evaluation.views.empty()) {
        evaluation.figures = {kInfinite, kInfinite};
        evaluation.limit = json.at("limit").get<double>();
    } else {
        evaluation.figures = combine(evaluation.views);
    }
    return evaluation;
}

} // namespace

Result<void> EvaluationStore::load(const std::string& path) {
    GLINT_TRY(text, readFile(path, kLongestStore));
    std::map<Key, Evaluation> evaluations;
    std::map<std::string, Timing> timings;
    std::string request;
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != kFormat)
            return invalidInput("{}: no state of this version of glint tune; give --resume another file",
                                printable(path));
        request = json.at("request").get<std::string>();
        for (const Json& each : json.at("evaluations")) {
            const ViewSet set = each.at("set") == setName(ViewSet::Held) ? ViewSet::Held : ViewSet::Search;
            evaluations[{set, each.at("settings").get<std::string>()}] = readEvaluation(each);
        }
        for (const Json& each : json.at("timings"))
            timings[each.at("settings").get<std::string>()] = {each.at("floors").get<double>(),
                                                               each.at("ms").get<double>()};
    } catch (const Json::exception&) {
        return invalidInput("{}: no state of glint tune; give --resume another file", printable(path));
    }
    if (request != request_)
        return invalidInput("{}: the state of a search with other scenes, contents of files, sizes or settings, or by "
                            "another build of glint; repeat that search, or give --resume another file",
                            printable(path));
    evaluations_ = std::move(evaluations);
    timings_ = std::move(timings);
    return {};
}

Result<void> EvaluationStore::save(const std::string& path) const {
    Json json = {{"format", kFormat}, {"request", request_}};
    json["evaluations"] = Json::array();
    for (const auto& [key, evaluation] : evaluations_)
        json["evaluations"].push_back(evaluationJson(key.first, key.second, evaluation));
    json["timings"] = Json::array();
    for (const auto& [settings, timing] : timings_)
        json["timings"].push_back({{"settings", settings}, {"floors", timing.floors}, {"ms", timing.ms}});
    return writeFile(path, json.dump(1) + "\n");
}

const Evaluation* EvaluationStore::find(const Settings& settings, ViewSet set) const {
    const auto found = evaluations_.find({set, keyOf(start_, settings)});
    return found == evaluations_.end() ? nullptr : &found->second;
}

void EvaluationStore::add(const Settings& settings, ViewSet set, Evaluation evaluation) {
    evaluations_[{set, keyOf(start_, settings)}] = std::move(evaluation);
}

const Timing* EvaluationStore::findTiming(const Settings& settings) const {
    const auto found = timings_.find(keyOf(start_, settings));
    return found == timings_.end() ? nullptr : &found->second;
}

void EvaluationStore::addTiming(const Settings& settings, const Timing& timing) {
    timings_[keyOf(start_, settings)] = timing;
}

} // namespace glint::tune
