#include "checker/compile/elf_file.hpp"

#include "checker/base/files.hpp"

#include <elf.h>

#include <cstddef>
#include <cstring>
#include <optional>
#include <string>

namespace workbook {
namespace {

/// A part of the file, copied because it may lie at any address; nothing if the file is too short.
template <class Part>
std::optional<Part> part_at(const std::string& bytes, std::uint64_t offset) {
  Part part;
  if (offset > bytes.size() || bytes.size() - offset < sizeof part) return std::nullopt;
  std::memcpy(&part, bytes.data() + offset, sizeof part);
  return part;
}

std::optional<Elf64_Ehdr> header_of(const std::string& bytes) {
  const auto header = part_at<Elf64_Ehdr>(bytes, 0);
  const bool is_ours = header && std::memcmp(header->e_ident, ELFMAG, SELFMAG) == 0 &&
                       header->e_ident[EI_CLASS] == ELFCLASS64 && header->e_ident[EI_DATA] == ELFDATA2LSB;
  return is_ours ? header : std::nullopt;
}

}  // namespace

bool has_section(const std::filesystem::path& object, std::string_view beginning) {
  const std::string bytes = read_file(object).value_or("");
  const std::optional<Elf64_Ehdr> header = header_of(bytes);
  if (!header) return true;
  const auto section = [&](std::uint64_t n) {
    return part_at<Elf64_Shdr>(bytes, header->e_shoff + n * sizeof(Elf64_Shdr));
  };
  const auto first = section(0);  // holds the numbers that are too large for the header
  if (!first) return true;
  const std::uint64_t count = header->e_shnum == 0 ? first->sh_size : header->e_shnum;
  const auto names = section(header->e_shstrndx == SHN_XINDEX ? first->sh_link : header->e_shstrndx);
  for (std::uint64_t n = 1; n < count; ++n) {
    const auto one = section(n);
    if (!one || !names || names->sh_offset > bytes.size()) return true;
    const std::string_view rest = std::string_view(bytes).substr(names->sh_offset);
    if (one->sh_name >= rest.size() || rest.substr(one->sh_name).starts_with(beginning)) return true;
  }
  return false;
}

bool has_interpreter(const std::filesystem::path& program) {
  const std::string bytes = read_file(program).value_or("");
  const std::optional<Elf64_Ehdr> header = header_of(bytes);
  if (!header) return true;
  for (std::uint64_t n = 0; n < header->e_phnum; ++n) {
    const auto segment = part_at<Elf64_Phdr>(bytes, header->e_phoff + n * sizeof(Elf64_Phdr));
    if (!segment || segment->p_type == PT_INTERP) return true;
  }
  return false;
}

}  // namespace workbook
