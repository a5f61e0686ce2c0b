// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/rplidar_parser.h>

#include <cmath>

namespace rtob
{
namespace
{
/// A consumer that stalls keeps the newest; each side holds a second or so.
constexpr std::size_t kMostWaiting = 16;
/// Several beams of a standard scan.
constexpr double kJump_deg = 5;

template <class Item>
std::optional<Item> take_first(std::deque<Item>& items)
{
    if (items.empty()) return std::nullopt;
    Item item = std::move(items.front());
    items.pop_front();
    return item;
}

template <class Item>
void add_bounded(std::deque<Item>& items, Item&& item)
{
    if (items.size() >= kMostWaiting) items.pop_front();
    items.push_back(std::forward<Item>(item));
}

bool is_scan(RplidarAnswer type)
{
    return type == RplidarAnswer::Standard || type == RplidarAnswer::Express ||
           type == RplidarAnswer::Ultra || type == RplidarAnswer::Dense;
}
}  // namespace

RplidarParser::RplidarParser(double byte_s, double max_gap_deg)
    : byte_s_(byte_s), builder_(max_gap_deg)
{
}

void RplidarParser::push(ByteView bytes, double arrival_s)
{
    bytes_.insert(bytes_.end(), bytes.data, bytes.data + bytes.size);
    arrival_s_ = arrival_s;
    while (step())
    {
    }
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
}

void RplidarParser::expectReply()
{
    descriptor_.reset();
    bytes_.clear();
    first_ = 0;
    capsules_.forget();
    builder_.forget();
    replies_.clear();
    revolutions_.clear();
}

std::optional<RplidarReply> RplidarParser::takeReply()
{
    return take_first(replies_);
}

std::optional<RplidarRevolution> RplidarParser::takeRevolution()
{
    return take_first(revolutions_);
}

RplidarCounters RplidarParser::counters() const
{
    return {builder_.revolutions(), builder_.partial(),    packets_,
            bytes_skipped_,         builder_.strayBeams(), packets_missed_ + capsules_.jumps()};
}

bool RplidarParser::step()
{
    if (!descriptor_) return findDescriptor();
    return descriptor_->is_stream ? readPacket() : readReply();
}

bool RplidarParser::findDescriptor()
{
    if (bytes_.size() - first_ < kRplidarDescriptor_bytes) return false;
    const auto found = read_descriptor({bytes_.data() + first_, kRplidarDescriptor_bytes});
    if (!found || (found->is_stream && (!is_scan(found->type) ||
                                        found->payload_bytes != rplidar_packet_bytes(found->type))))
    {
        skipByte();
        return true;
    }
    consume(kRplidarDescriptor_bytes);
    descriptor_ = found;
    if (!found->is_stream) return true;
    packets_missed_ += capsules_.jumps();
    capsules_ = CapsuleReader(
        found->type, sample_s_ * static_cast<double>(rplidar_beams_of_packet(found->type)));
    stamps_ = SteadyStamps(sample_s_);
    add_bounded(replies_, RplidarReply{found->type, true, {}});
    return true;
}

bool RplidarParser::readReply()
{
    const std::size_t count = descriptor_->payload_bytes;
    if (bytes_.size() - first_ < count) return false;
    const auto* begin = bytes_.data() + first_;
    add_bounded(replies_, RplidarReply{descriptor_->type, false, Bytes(begin, begin + count)});
    consume(count);
    descriptor_.reset();
    return true;
}

bool RplidarParser::readPacket()
{
    const std::size_t count = rplidar_packet_bytes(descriptor_->type);
    if (bytes_.size() - first_ < count) return false;
    const ByteView packet(bytes_.data() + first_, count);
    if (!is_rplidar_packet(descriptor_->type, packet))
    {
        skipByte();
        capsules_.forget();
        stamps_.forget();
        return true;
    }
    addBeams(packet);
    consume(count);
    ++packets_;
    return true;
}

void RplidarParser::addBeams(ByteView packet)
{
    if (descriptor_->type == RplidarAnswer::Standard)
    {
        RplidarBeam beam = read_standard_packet(packet);
        if (std::abs(std::remainder(beam.shaft_deg - last_shaft_deg_, 360.0)) > kJump_deg)
            stamps_.forget();  // packets were lost
        last_shaft_deg_ = beam.shaft_deg;
        beam.time_s = stamps_.sent(sentAt(first_));
        addBeam(beam);
        return;
    }
    for (const auto& beam : capsules_.read(packet, sentAt(first_))) addBeam(beam);
}

void RplidarParser::addBeam(const RplidarBeam& beam)
{
    if (auto ended = builder_.add(beam)) add_bounded(revolutions_, std::move(*ended));
}

/// When the byte at this place of the buffer began to leave the device.
double RplidarParser::sentAt(std::size_t offset) const
{
    return arrival_s_ - byte_s_ * static_cast<double>(bytes_.size() - offset);
}

void RplidarParser::skipByte()
{
    ++first_;
    ++bytes_skipped_;
}

void RplidarParser::consume(std::size_t count)
{
    first_ += count;
}
}  // namespace rtob
