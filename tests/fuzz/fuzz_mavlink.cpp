// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/mavlink_codec.h>

#include <algorithm>
#include <cstdlib>

/// Any bytes, in chunks of any size: no crash, and a frame that comes out goes in again as it was.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 1) return 0;
    const std::size_t chunk = 1U + data[0];
    rtob::MavlinkReader reader;
    for (std::size_t at = 1; at < size; at += chunk)
    {
        reader.push({data + at, std::min(chunk, size - at)});
        while (const auto frame = reader.take())
            rtob::mavlink::for_each_message(
                [&](const auto& kind)
                {
                    using Message = std::decay_t<decltype(kind)>;
                    const auto message = rtob::mavlink::message_of<Message>(*frame);
                    if (!message) return;
                    auto payload = rtob::mavlink::pack(*message);
                    payload.resize(std::max(payload.size(), frame->payload.size()));
                    for (std::size_t i = 0; i < payload.size(); ++i)
                        if (payload[i] != (i < frame->payload.size() ? frame->payload[i] : 0))
                            std::abort();
                });
    }
    return 0;
}
