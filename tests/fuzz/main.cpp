// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <cstdlib>
#include <random>

#include "scene/field/field.h"
#include "scene/mesh/readers.h"
#include "tests/fuzz/seeds.h"
#include "tests/support/folder.h"
#include "tests/support/scenes.h"

namespace {

using bracket::scene::RawMesh;
using Random = std::mt19937_64;

struct Reader {
  const char* name;               ///< also the ending of its files
  bracket::scene::Status status;  ///< of what it refuses
  /// Reads a file. \return what is wrong with what it has read; empty: nothing
  std::string (*read)(const std::filesystem::path&, std::uint64_t seed);
  std::vector<std::string> seeds, words;
};

template <RawMesh (*reader)(const std::filesystem::path&)>
std::string read_mesh(const std::filesystem::path& file, std::uint64_t seed) {
  bracket::scene::Scene<2> scene;
  scene.merge = seed % 2 == 0 ? 0 : 1e-6;
  const auto mesh = mesh_of(reader(file), scene, "mesh");
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    if (!(volume(mesh, cell) > 0)) return "a cell without area";
  return "";
}

/// A displacement of two blocks of two triangles each.
std::string read_displacement(const std::filesystem::path& file, std::uint64_t) {
  static const bracket::scene::Mesh<2> mesh = build_mesh(bracket::tests::two_blocks(1));
  const auto [degree, vertex, edge, cell] = read_field(file, mesh).displacement;
  if (vertex.size() != mesh.vertices.size() || edge.size() != (degree == 2 ? mesh.edges.size() : 0) || !cell.empty())
    return "nodes without values";
  for (const auto* values : {&vertex, &edge})
    for (const auto& u : *values)
      if (!u.allFinite()) return "a value that is not finite";
  return "";
}

std::size_t below(Random& random, std::size_t end) { return random() % std::max<std::size_t>(end, 1); }

/// Where the word at a place of a text begins and ends.
std::pair<std::size_t, std::size_t> word_at(const std::string& text, std::size_t at) {
  constexpr const char* between = " ,\n";
  const std::size_t before = text.find_last_of(between, at);
  return {before == std::string::npos ? 0 : before + 1, std::min(text.find_first_of(between, at), text.size())};
}

/// The text with one fault: a byte, a stretch that is missing, doubled or elsewhere, a word of its own or of others in
/// the place of another, a line of another text.
std::string changed(std::string text, const Reader& reader, Random& random) {
  const std::size_t at = below(random, text.size()), length = below(random, 40);
  const std::string stretch = text.substr(at, length);
  switch (random() % 16) {
    case 0: text[at] = static_cast<char>(random()); break;
    case 1: text[at] = "0123456789-+.eE, \n*$"[random() % 20]; break;
    case 2: text.erase(at, length); break;
    case 3: text.insert(below(random, text.size()), stretch); break;
    case 4: text.replace(below(random, text.size()), length, stretch); break;
    case 5: text.resize(at); break;
    case 6: text.insert(at, reader.words[below(random, reader.words.size())]); break;
    case 7: {
      const std::string& other = reader.seeds[below(random, reader.seeds.size())];
      const std::size_t from = below(random, other.size()), start = other.rfind('\n', from) + 1;
      text.insert(text.rfind('\n', at) + 1, other.substr(start, other.find('\n', from) + 1 - start));
      break;
    }
    default: {
      const auto [from, to] = word_at(text, below(random, text.size()));
      const std::string word = text.substr(from, std::max(from, to) - from);
      const auto [begin, end] = word_at(text, at);
      text.replace(begin, std::max(begin, end) - begin, word);
    }
  }
  return text;
}

/// The text number `seed` of a reader: the first are its seeds, others one of these with faults, each as likely as all
/// that follow.
std::string text_of(const Reader& reader, std::uint64_t seed) {
  if (seed < reader.seeds.size()) return reader.seeds[seed];
  Random random(seed);
  std::string text = reader.seeds[below(random, reader.seeds.size())];
  for (int faults = 1 + std::countr_zero(random() | 256); faults > 0 && !text.empty(); --faults)
    text = changed(std::move(text), reader, random);
  return text;
}

struct Count {
  std::uint64_t read = 0, refused = 0, faults = 0;
  double slowest = 0;
};

/// Whatever a text is, it is read or refused with one line and the reader's status.
Count judge(const Reader& reader, std::uint64_t first, std::uint64_t last) {
  const bracket::tests::Folder folder;
  Count count;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const std::filesystem::path file = folder.write(std::string("file.") + reader.name, text_of(reader, seed));
    const auto start = std::chrono::steady_clock::now();
    std::string fault;
    try {
      fault = reader.read(file, seed);
      ++count.read;
    } catch (const bracket::scene::Error& error) {
      ++count.refused;
      if (seed < reader.seeds.size()) fault = error.what();
      if (error.status() != reader.status) fault = error.what();
      if (std::string(error.what()).find('\n') != std::string::npos) fault = "a message of several lines";
    } catch (const std::exception& error) {
      fault = error.what();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    count.slowest = std::max(count.slowest, seconds.count());
    if (fault.empty()) continue;
    ++count.faults;
    fmt::print("{} {}: {}\n", reader.name, seed, fault);
  }
  return count;
}

}  // namespace

/// bracket_fuzz_meshes FIRST LAST: gives the readers of mesh files and of displacements the texts of these numbers,
/// from 0 on, and prints those that are neither read nor properly refused. Exit status 1 if there were any.
int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: bracket_fuzz_meshes FIRST LAST\n");
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  namespace seeds = bracket::tests::seeds;
  using namespace bracket::scene;
  const std::vector<Reader> readers = {
      {"msh", Status::mesh, read_mesh<read_gmsh>, seeds::gmsh(), seeds::gmsh_words()},
      {"inp", Status::mesh, read_mesh<read_abaqus>, seeds::abaqus(), seeds::abaqus_words()},
      {"unv", Status::mesh, read_mesh<read_unv>, seeds::unv(), seeds::unv_words()},
      {"csv", Status::input, read_displacement, seeds::csv(), seeds::csv_words()},
      {"frd", Status::input, read_displacement, seeds::frd(), seeds::frd_words()}};
  std::uint64_t faults = 0;
  for (const Reader& reader : readers) {
    const Count count = judge(reader, first, last);
    faults += count.faults;
    fmt::print("{}: {} read, {} refused, {} faults, the slowest took {:.3f} s\n", reader.name, count.read,
               count.refused, count.faults, count.slowest);
  }
  if (faults == 0) fmt::print("[  PASSED  ] 1 test.\n");  // tests/run.sh counts it among GoogleTest's
  return faults == 0 ? 0 : 1;
}
