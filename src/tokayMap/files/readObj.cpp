// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/readObj.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace tokay::tool {

namespace {

class ObjReader {
  public:
    explicit ObjReader(const std::string& path) : path_(path) {}

    MeshFile read() {
        std::ifstream file(path_);
        if (!file) {
            throw InputError(fmt::format("{}: the file cannot be opened", path_));
        }
        for (std::string line; std::getline(file, line);) {
            ++lineNumber_;
            addLine(line);
        }
        MeshFile mesh;
        mesh.isLines = faces_.empty();
        mesh.cells = mesh.isLines ? std::move(lines_) : std::move(faces_);
        if (mesh.cells.empty()) {
            throw InputError(fmt::format("{}: there is neither a face nor a line in it", path_));
        }
        mesh.vertices = Eigen::Map<const Points>(coordinates_.data(), coordinates_.size() / 3, 3);
        return mesh;
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(fmt::format("{}:{}: {}", path_, lineNumber_, message));
    }

    void addLine(const std::string& line) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string key;
        words >> key;
        if (key == "v") {
            addVertex(words);
        } else if (key == "f") {
            addFace(words);
        } else if (key == "l") {
            addPolyline(words);
        }
    }

    void addVertex(std::istringstream& words) {
        for (int i = 0; i < 3; ++i) {
            double value;
            if (!(words >> value)) {
                fail("a vertex needs three numbers");
            }
            coordinates_.push_back(value);
        }
    }

    void addFace(std::istringstream& words) {
        const std::vector<int> vertices = readVertices(words);
        if (vertices.size() < 3) {
            fail(fmt::format("a face needs at least three vertices, this one has {}",
                             vertices.size()));
        }
        faces_.push_back(vertices);
    }

    void addPolyline(std::istringstream& words) {
        const std::vector<int> vertices = readVertices(words);
        if (vertices.size() < 2) {
            fail("a line needs at least two vertices");
        }
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
            lines_.push_back({vertices[i], vertices[i + 1]});
        }
    }

    /// "v", "v/vt", "v//vn" or "v/vt/vn", from 1 on or, negative, back from the
    /// last vertex before the line.
    std::vector<int> readVertices(std::istringstream& words) const {
        const auto nVertices = static_cast<long>(coordinates_.size() / 3);
        std::vector<int> vertices;
        for (std::string word; words >> word;) {
            char* end = nullptr;
            const long number = std::strtol(word.c_str(), &end, 10);
            if (end == word.c_str() || (*end != '\0' && *end != '/')) {
                fail(fmt::format("'{}' is not the number of a vertex", word));
            }
            const long vertex = number < 0 ? nVertices + number : number - 1;
            if (number == 0 || vertex < 0 || vertex >= nVertices) {
                fail(fmt::format("there is no vertex {}: {} stand before this line (indices "
                                 "start at 1)",
                                 number, nVertices));
            }
            vertices.push_back(static_cast<int>(vertex));
        }
        return vertices;
    }

    std::string path_;
    int lineNumber_ = 0;
    std::vector<double> coordinates_;
    std::vector<std::vector<int>> faces_, lines_;
};

} // namespace

MeshFile readObj(const std::string& path) {
    return ObjReader(path).read();
}

} // namespace tokay::tool
