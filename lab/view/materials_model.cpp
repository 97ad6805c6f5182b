#include "lab/view/materials_model.hpp"

#include "base/file.hpp"

#include <utility>

namespace glint::view {

MaterialsModel::MaterialsModel(const render::JobInputs& inputs, std::string fileName)
    : file(std::move(fileName)), materials_(inputs.fileMaterials), overrides_(inputs.overrides) {}

scene::MaterialKind MaterialsModel::kind(size_t material) const {
    const auto found = overrides_.find(material);
    return found == overrides_.end() ? scene::kindOf(materials_[material])
                                     : scene::kindOf(materials_[material], found->second);
}

bool MaterialsModel::has(size_t material, const scene::MaterialField& field) const {
    return (field.kinds & scene::kindBit(kind(material))) != 0;
}

scene::FieldValue MaterialsModel::value(size_t material, size_t field) const {
    scene::MaterialOverride kindAlone;
    if (const auto found = overrides_.find(material); found != overrides_.end()) {
        if (const auto value = found->second.values.find(field); value != found->second.values.end())
            return value->second;
        kindAlone.kind = found->second.kind;
    }
    return scene::materialFields()[field].get(scene::overridden(materials_[material], kindAlone));
}

bool MaterialsModel::changed(size_t material, size_t field) const {
    const auto found = overrides_.find(material);
    return found != overrides_.end() && found->second.values.contains(field);
}

bool MaterialsModel::changed(size_t material) const {
    return overrides_.contains(material);
}

scene::MaterialOverride& MaterialsModel::edit(size_t material) {
    ++version_;
    return overrides_[material];
}

void MaterialsModel::dropIfEmpty(size_t material) {
    if (overrides_[material].empty())
        overrides_.erase(material);
}

void MaterialsModel::setKind(size_t material, scene::MaterialKind kind) {
    scene::MaterialOverride& override = edit(material);
    override.kind = kind;
    if (kind == scene::kindOf(materials_[material]))
        override.kind.reset();
    dropIfEmpty(material);
}

void MaterialsModel::set(size_t material, size_t field, scene::FieldValue value) {
    edit(material).values[field] = value;
}

void MaterialsModel::reset(size_t material, size_t field) {
    edit(material).values.erase(field);
    dropIfEmpty(material);
}

void MaterialsModel::reset(size_t material) {
    edit(material) = {};
    dropIfEmpty(material);
}

void MaterialsModel::replace(scene::MaterialOverrides overrides) {
    overrides_ = std::move(overrides);
    ++version_;
}

Result<void> MaterialsModel::save(const std::string& path) {
    GLINT_CHECK(writeFile(path, scene::materialFileText(path, materials_, overrides_)));
    savedVersion_ = version_;
    savedFile_ = path;
    return {};
}

} // namespace glint::view
