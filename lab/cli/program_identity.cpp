#include "lab/cli/program_identity.hpp"

#include "glint/version.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace glint::cli {
namespace {

/// The digits of the GNU build ID in a segment of notes; empty if it has none.
std::string buildIdIn(std::span<const std::byte> notes) {
    const auto padded = [](size_t size) { return (size + 3) & ~size_t{3}; };
    while (notes.size() >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) note;
        std::memcpy(&note, notes.data(), sizeof note);
        const size_t name = sizeof note, value = name + padded(note.n_namesz), end = value + padded(note.n_descsz);
        if (end > notes.size())
            break;
        if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(&notes[name], "GNU", 4) == 0) {
            std::string digits;
            for (const std::byte byte : notes.subspan(value, note.n_descsz))
                digits += fmt::format("{:02x}", std::to_integer<unsigned>(byte));
            return digits;
        }
        notes = notes.subspan(end);
    }
    return {};
}

/// Called for each loaded object, the program first; stops there.
int findBuildId(dl_phdr_info* object, size_t /*size*/, void* found) {
    for (ElfW(Half) i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr)& segment = object->dlpi_phdr[i];
        if (segment.p_type != PT_NOTE)
            continue;
        const auto* const bytes = reinterpret_cast<const std::byte*>(object->dlpi_addr + segment.p_vaddr);
        std::string& digits = *static_cast<std::string*>(found);
        digits = buildIdIn({bytes, segment.p_memsz});
        if (!digits.empty())
            break;
    }
    return 1;
}

} // namespace

std::string programIdentity() {
    std::string build;
    dl_iterate_phdr(findBuildId, &build);
    const std::string version =
        fmt::format("glint {}.{}.{}", GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH);
    return build.empty() ? version : fmt::format("{}, build {}", version, build);
}

} // namespace glint::cli
