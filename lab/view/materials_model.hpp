// The materials of the open scene as the user changes them: overrides (lab/scene/material_overrides.hpp), the chosen
// material, and the file that they are saved in. Without a window.
#pragma once

#include "lab/job/job_inputs.hpp"

#include <optional>
#include <string>
#include <vector>

namespace glint::view {

class MaterialsModel {
public:
    MaterialsModel() = default;
    /// `file`  that changes are saved in
    MaterialsModel(const render::JobInputs& inputs, std::string file);

    size_t size() const { return materials_.size(); }
    /// "floor", or "#3" for a material without a name of its own.
    std::string name(size_t material) const { return scene::materialKey(materials_, material); }
    const scene::MaterialOverrides& overrides() const { return overrides_; }
    /// Increases with every change; 0: as the scene was opened.
    uint64_t version() const { return version_; }

    scene::MaterialKind kind(size_t material) const;
    bool has(size_t material, const scene::MaterialField& field) const;
    scene::FieldValue value(size_t material, size_t field) const;
    /// True if the user, or the file of overrides, has set the field.
    bool changed(size_t material, size_t field) const;
    bool changed(size_t material) const;

    void setKind(size_t material, scene::MaterialKind kind);
    void set(size_t material, size_t field, scene::FieldValue value);
    void reset(size_t material, size_t field);
    void reset(size_t material);
    /// Replaces all overrides, as read from a file.
    void replace(scene::MaterialOverrides overrides);

    /// Writes the overrides, which `--materials` reads. Errors: those of writeFile.
    Result<void> save(const std::string& path);
    bool unsaved() const { return version_ != savedVersion_; }
    const std::string& savedFile() const { return savedFile_; } ///< empty: nothing was saved

    std::optional<size_t> chosen; ///< the material that the panel shows
    std::string file;             ///< name in the panel

private:
    scene::MaterialOverride& edit(size_t material);
    void dropIfEmpty(size_t material);

    std::vector<scene::Material> materials_; ///< of the scene's file
    scene::MaterialOverrides overrides_;
    uint64_t version_ = 0;
    uint64_t savedVersion_ = 0;
    std::string savedFile_;
};

} // namespace glint::view
