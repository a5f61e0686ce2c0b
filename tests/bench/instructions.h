// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace rtob::bench
{
/// Counts this thread's instructions in user space while it lives and adds them to the row, an
/// iteration. Where the kernel or a virtual machine has no counter the row has none either;
/// share/scripts/count-instructions.sh counts there.
class InstructionCount
{
 public:
    explicit InstructionCount(benchmark::State& state) : state_(state)
    {
        perf_event_attr attributes{};
        attributes.size = sizeof(attributes);
        attributes.type = PERF_TYPE_HARDWARE;
        attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
        attributes.exclude_kernel = 1;
        attributes.exclude_hv = 1;
        counter_ = static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
        begin_ = read();
    }
    ~InstructionCount()
    {
        if (counter_ < 0) return;
        state_.counters["instructions"] = benchmark::Counter(
            static_cast<double>(read() - begin_), benchmark::Counter::kAvgIterations);
        close(counter_);
    }
    InstructionCount(const InstructionCount&) = delete;
    InstructionCount& operator=(const InstructionCount&) = delete;

 private:
    [[nodiscard]] std::uint64_t read() const
    {
        std::uint64_t count = 0;
        if (counter_ < 0 || ::read(counter_, &count, sizeof(count)) != sizeof(count)) return 0;
        return count;
    }

    benchmark::State& state_;
    int counter_ = -1;
    std::uint64_t begin_ = 0;
};
}  // namespace rtob::bench
