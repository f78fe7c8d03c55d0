// What the program ripstop-mesh-reader (app/mesh_reader) says to whoever started it, as bytes
// through a pipe: records, each with its kind (1 byte), its length (8 bytes) and its content.
//
//     progress  a double, 0 to 1
//     trouble   why there is no mesh: a ReadTrouble (1 byte), and what the library says of it
//     mesh      the fields of a PolygonMesh (base/bytes.h)
//
// A mesh or a trouble is the last record. The reader of a broken file may have gone mad before it
// answered, so nothing in an answer is believed: lengths are those of bytes that are there, and
// indices are looked at.
#pragma once

#include "shapes/polygon_mesh.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ripstop {

enum class ReadTrouble : std::uint8_t {
    UnknownFormat, // nobody reads such files
    Unreadable,    // the library says why
    TooManyBytes,  // in the file and those that it names
    TooMuchMemory  // for so many bytes
};

// A record each.
std::string progressRecord(double share);
std::string troubleRecord(ReadTrouble trouble, std::string_view why = {});
std::string meshRecord(const PolygonMesh& mesh);

// Takes the bytes of an answer as they come.
class MeshAnswer
{
public:
    // False when they are no answer; more need not be given then.
    bool take(std::string_view bytes);

    bool isOver() const { return m_mesh || m_trouble; }
    double share() const { return m_share; } // of the work that is done
    std::optional<PolygonMesh>& mesh() { return m_mesh; }
    std::optional<ReadTrouble> trouble() const { return m_trouble; }
    const std::string& why() const { return m_why; } // the trouble is

private:
    bool takeRecord(std::uint8_t kind, std::string_view content);

    std::string m_bytes; // of the record that is not whole yet
    double m_share = 0.0;
    std::optional<PolygonMesh> m_mesh;
    std::optional<ReadTrouble> m_trouble;
    std::string m_why;
};

} // namespace ripstop
