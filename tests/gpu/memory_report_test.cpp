// Context::memory: what the library's objects use, by name, and what the driver gave for them.
#include "gpu/memory.hpp"
#include "gpu/support/library_test.hpp"

#include <algorithm>
#include <numeric>

namespace glint::test {
namespace {

class MemoryReportTest : public LibraryTest {
protected:
    static uint64_t bytesOf(const MemoryReport& report, std::string_view name) {
        const auto found = std::ranges::find(report.uses, name, &MemoryUse::name);
        return found == report.uses.end() ? 0 : found->bytes;
    }
    static Reflections make(uint32_t width, uint32_t height, bool denoises) {
        ReflectionsDesc desc;
        desc.width = width;
        desc.height = height;
        desc.settings.denoise.enabled = denoises;
        return must(Reflections::create(library(), desc));
    }
};

TEST_F(MemoryReportTest, NamesEveryImageAndBufferAndSumsToWhatIsAllocated) {
    const uint64_t before = library().memory().bytes;
    {
        const Reflections reflections = make(640, 360, false);
        const MemoryReport report = library().memory();
        EXPECT_EQ(report.bytes, gpu::allocatedBytes(library().gpu().allocator()));
        EXPECT_EQ(report.bytes, std::accumulate(report.uses.begin(), report.uses.end(), uint64_t{0},
                                                [](uint64_t sum, const MemoryUse& use) { return sum + use.bytes; }));
        EXPECT_GE(bytesOf(report, "glint/surface"), uint64_t{640} * 360 * 8);
        EXPECT_TRUE(std::ranges::is_sorted(report.uses, std::greater(), &MemoryUse::bytes));
        for (const MemoryUse& use : report.uses)
            EXPECT_TRUE(!use.name.empty() && use.bytes > 0 && use.count > 0) << use.name;
    }
    EXPECT_EQ(library().memory().bytes, before) << "nothing is left";
}

TEST_F(MemoryReportTest, TheDriverGivesLittleMoreThanAFrameUses) {
    const MemoryReport before = library().memory();
    const Reflections reflections = make(1920, 1080, true);
    const MemoryReport report = library().memory();
    EXPECT_GE(report.taken, report.bytes);
    const auto used = static_cast<double>(report.bytes - before.bytes);
    const auto taken = static_cast<double>(report.taken) - static_cast<double>(before.taken);
    EXPECT_LE(taken, 1.05 * used);
    RecordProperty("bytesPerPixel", std::to_string(taken / (1920.0 * 1080.0)));
}

TEST_F(MemoryReportTest, WithoutTheDenoiserAFrameTakesLess) {
    const uint64_t before = library().memory().bytes;
    const uint64_t plain = [&] {
        const Reflections reflections = make(640, 360, false);
        return library().memory().bytes - before;
    }();
    const Reflections reflections = make(640, 360, true);
    const MemoryReport report = library().memory();
    EXPECT_GT(report.bytes - before, plain + uint64_t{640} * 360 * 40);
    EXPECT_GT(bytesOf(report, "glint/mean"), 0U);
}

} // namespace
} // namespace glint::test
