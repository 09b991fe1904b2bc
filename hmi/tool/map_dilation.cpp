// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/map_dilation.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <new>
#include <system_error>
#include <thread>

#include "hmi/tool/dilation_block.hpp"

namespace psicarve::tool {
namespace {

using namespace dilation;

class DilationWork {
public:
    DilationWork(const DilationScene& scene, std::vector<float>& tips, const slice::Progress& progress)
        : scene_(scene),
          tips_(tips),
          progress_(progress),
          block_count_((scene.surface.row_count + kBlockRows - 1) / kBlockRows) {}

    bool is_cancelled() const noexcept { return is_cancelled_; }

    void run_on(unsigned thread_count) {
        std::vector<std::thread> threads;
        try {
            for (std::size_t i = 1; i < std::min<std::size_t>(thread_count, block_count_); ++i)
                threads.emplace_back([this] { run(false); });
        } catch (const std::system_error&) {
            // This thread does the work of one that the system does not give.
        }
        run(true);
        for (std::thread& thread : threads) thread.join();
    }

private:
    void run(bool tells) {
        for (;;) {
            if (tells) tell();
            const std::size_t block = next_block_.fetch_add(1);
            if (block >= block_count_ || is_cancelled_) return;
            DilationBlock(scene_, block * kBlockRows).fill_rows(tips_);
            blocks_done_.fetch_add(1);
        }
    }
    void tell() {
        const double share = static_cast<double>(blocks_done_) / static_cast<double>(block_count_);
        if (progress_ && !progress_(share)) is_cancelled_ = true;
    }

    const DilationScene& scene_;
    std::vector<float>& tips_;
    const slice::Progress& progress_;
    std::size_t block_count_;
    std::atomic<std::size_t> next_block_{0};
    std::atomic<std::size_t> blocks_done_{0};
    std::atomic<bool> is_cancelled_{false};
};

}  // namespace

Result<std::vector<float>> dilated(const SampledRadii& surface, const Tool& tool, double allowance,
                                   const slice::SliceOptions& options) {
    try {
        std::vector<float> tips(surface.radius.size(), 0.0F);
        const unsigned threads = std::max(1U, options.thread_count);
        const DilationScene scene(surface, tool, threads);
        DilationWork work(scene, tips, options.progress);
        work.run_on(threads);
        if (work.is_cancelled())
            return Error{ErrorCode::cancelled, "the tool's way over the samples was cancelled"};
        for (float& tip : tips) tip += static_cast<float>(allowance);
        return tips;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory for the tool's way over so many samples"};
    }
}

}  // namespace psicarve::tool
