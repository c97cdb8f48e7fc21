// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/files/ByteStream.hpp"

#include <pugixml.hpp>

#include <vector>

namespace tokay::tool {

/// A VTK XML file (.vtu, .vtp) and the numbers of its arrays: as text, inline
/// base64, or appended raw or as base64; plain or compressed by zlib.
class VtkArrays {
  public:
    /// @throws InputError for a file that cannot be read, is no XML, or is written
    /// in a way that is not supported (byte order, compressor)
    explicit VtkArrays(const std::string& path);

    /// Element VTKFile.
    pugi::xml_node root() const { return document_.child("VTKFile"); }

    /// Numbers of a DataArray element, all components of a tuple together.
    /// @throws InputError naming file and array
    std::vector<double> numbers(pugi::xml_node array) const;

    /// Numbers of a DataArray element that must have n of them.
    /// @throws InputError too if there are not
    std::vector<double> numbers(pugi::xml_node array, std::size_t n) const;

    /// Count that an attribute announces; fallback if it is not there.
    /// @throws InputError if a file of this size cannot hold as many
    std::size_t count(pugi::xml_node node, const char* attribute, std::size_t fallback = 0) const;

    /// DataArray element in another one; the first if no name is given.
    /// @throws InputError if there is none
    pugi::xml_node arrayIn(pugi::xml_node parent, const std::string& name = "") const;

    /// @throws InputError that begins with the path
    [[noreturn]] void fail(const std::string& message) const;

  private:
    void splitOffAppended(const std::string& content);
    void readAttributes();
    ByteStream stream(pugi::xml_node array) const;
    std::size_t takeHeader(ByteStream& stream) const;
    std::string bytes(ByteStream stream) const;
    std::string uncompressed(ByteStream& stream) const;

    std::string path_;
    std::size_t fileSize_ = 0;
    pugi::xml_document document_;
    std::string appended_;
    ByteEncoding appendedEncoding_ = ByteEncoding::raw;
    std::size_t headerSize_ = 4;
    bool isCompressed_ = false;
};

} // namespace tokay::tool
