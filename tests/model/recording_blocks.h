// A file of a recording taken apart into its blocks and put together again with right checksums, so
// that tests can forge what is in them (io/recording_file.h has the form).
#pragma once

#include "recording/packed.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

struct RecordingBlock
{
    enum Kind : std::uint32_t { About = 1, Design, Stretch, End, Certificate };

    std::uint32_t kind = End;
    std::string content;
};

struct RecordingBlocks
{
    std::string firstLine;
    std::vector<RecordingBlock> blocks;

    RecordingBlock* first(std::uint32_t kind)
    {
        for (RecordingBlock& block : blocks)
            if (block.kind == kind)
                return &block;
        return nullptr;
    }
};

// Of a whole file, or as far as it is one.
inline RecordingBlocks blocksOf(std::string_view file)
{
    RecordingBlocks found;
    const std::size_t line = std::min(file.find('\n'), file.size() - 1) + 1;
    found.firstLine = file.substr(0, line);
    file.remove_prefix(line);
    constexpr std::size_t head = sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t);
    while (file.size() >= head) {
        RecordingBlock& block = found.blocks.emplace_back();
        std::uint64_t length = 0;
        std::memcpy(&block.kind, file.data(), sizeof block.kind);
        std::memcpy(&length, file.data() + sizeof block.kind, sizeof length);
        block.content = file.substr(head, std::size_t(length));
        file.remove_prefix(head + block.content.size());
    }
    return found;
}

inline std::string fileOf(const RecordingBlocks& recording)
{
    std::string file = recording.firstLine;
    const auto add = [&](const auto& value) {
        file.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (const RecordingBlock& block : recording.blocks) {
        add(block.kind);
        add(std::uint64_t(block.content.size()));
        add(checksum(block.content) ^ (std::uint64_t(block.kind) * 0x9e3779b97f4a7c15u));
        file += block.content;
    }
    return file;
}

// What a block of a stretch is made of: both packed.
struct StretchParts
{
    std::string head;
    std::string frames;
};

inline StretchParts partsOf(const std::string& content)
{
    std::uint64_t length = 0;
    if (content.size() < sizeof length)
        return {};
    std::memcpy(&length, content.data(), sizeof length);
    const std::string rest = content.substr(sizeof length);
    length = std::min<std::uint64_t>(length, rest.size());
    return {rest.substr(0, std::size_t(length)), rest.substr(std::size_t(length))};
}

inline std::string contentOf(const StretchParts& parts)
{
    const std::uint64_t length = parts.head.size();
    return std::string(reinterpret_cast<const char*>(&length), sizeof length) + parts.head
           + parts.frames;
}

} // namespace ripstop
