// Everything that a search has evaluated, kept in a file: a search that was interrupted runs again from its start and
// finds here what it already knows, so it ends as if nothing had happened.
#pragma once

#include "lab/tune/evaluator.hpp"

#include <map>
#include <string>

namespace glint::tune {

/// Figures survive the file to the bit.
class EvaluationStore {
public:
    /// `request`  everything that evaluations depend on besides the settings varied, as one text
    EvaluationStore(std::string request, Settings start) : request_(std::move(request)), start_(start) {}

    /// Reads a file that `save` wrote. Errors: NotFound; InvalidInput for another request, or for anything else that a
    /// search has not written.
    Result<void> load(const std::string& path);
    /// Writes the whole file under a temporary name and renames it. Errors: Io.
    Result<void> save(const std::string& path) const;

    const Evaluation* find(const Settings& settings, ViewSet set) const;
    void add(const Settings& settings, ViewSet set, Evaluation evaluation);
    const Timing* findTiming(const Settings& settings) const;
    void addTiming(const Settings& settings, const Timing& timing);
    size_t size() const { return evaluations_.size(); }

private:
    using Key = std::pair<ViewSet, std::string>; ///< the differences from the start, one a line
    std::string request_;
    Settings start_;
    std::map<Key, Evaluation> evaluations_;
    std::map<std::string, Timing> timings_;
};

} // namespace glint::tune
