// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/feature_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/files/bytes.h"
#include "core/files/sha256.h"

namespace cvo {
namespace {

constexpr std::string_view kMagic = "CVOFEATS";
constexpr std::size_t kHeaderBytes =
    kMagic.size() + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t) + kHashBytes + kHashBytes;
constexpr std::size_t kPlaceBytes = 2 * sizeof(std::uint64_t) + kHashBytes;

struct Header {
  std::uint32_t frames = 0;
  std::uint64_t index_offset = 0;
  std::string key;
};

std::string Encode(const Header& header) {
  std::string bytes(kMagic);
  AppendNumber(kFeatureFileVersion, bytes);
  AppendNumber(header.frames, bytes);
  AppendNumber(header.index_offset, bytes);
  bytes += header.key;
  return bytes + Sha256Hex(bytes);
}

// Returns the bytes without the checksum after them, which it verifies.
std::string_view Checked(std::string_view bytes, const std::string& name, const char* part) {
  const std::string_view content = bytes.substr(0, bytes.size() - kHashBytes);
  if (Sha256Hex(content) != bytes.substr(content.size())) {
    ThrowError(name, StrCat("damage in the ", part), "the bytes that were written");
  }
  return content;
}

Header DecodeHeader(const std::string& bytes, const std::string& name) {
  ByteReader reader(bytes);
  if (reader.Take(kMagic.size()) != kMagic) {
    ThrowError(name, "another file", "features of a sequence");
  }
  const auto version = reader.Number<std::uint32_t>();
  if (version != kFeatureFileVersion) {
    ThrowError(name, StrCat("version ", version), StrCat(kFeatureFileVersion));
  }
  (void)Checked(bytes, name, "header");
  Header header;
  header.frames = reader.Number<std::uint32_t>();
  header.index_offset = reader.Number<std::uint64_t>();
  header.key = reader.Take(kHashBytes);
  return header;
}

std::uint64_t SizeOf(const FileDescriptor& file, const std::string& name) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) ThrowErrno(name, "read", errno);
  if (!S_ISREG(status.st_mode)) ThrowError(name, "no regular file", "features of a sequence");
  return static_cast<std::uint64_t>(status.st_size);
}

}  // namespace

// Opens the file only once, as another process may remove it and write it again at any time.
std::optional<FeatureFile> FeatureFile::Open(const std::filesystem::path& file,
                                             const std::string& key, std::size_t frames) {
  FileDescriptor opened(file, O_RDONLY | O_NONBLOCK);  // opening a pipe would wait for its writer
  if (opened.get() < 0 && errno == ENOENT) return std::nullopt;
  if (opened.get() < 0) ThrowErrno(file, "read", errno);
  return FeatureFile(std::move(opened), file.string(), key, frames);
}

FeatureFile::FeatureFile(FileDescriptor file, const std::string& name, const std::string& key,
                         std::size_t frames)
    : name_(name), file_(std::move(file)), size_bytes_(SizeOf(file_, name_)) {
  const Header header = DecodeHeader(Read(0, kHeaderBytes), name_);
  if (header.key != key || header.frames != frames) {
    ThrowError(name_, StrCat(header.frames, " frames under the key ", header.key),
               StrCat(frames, " under ", key));
  }
  places_ = ReadIndex(header.index_offset, frames);
}

std::string FeatureFile::Read(std::uint64_t offset, std::uint64_t count) const {
  const bool there = count <= size_bytes_ && offset <= size_bytes_ - count;
  std::string bytes(there ? count : 0, '\0');
  const std::ptrdiff_t read = there ? ReadUpTo(file_, bytes.data(), count, offset) : 0;
  if (read < 0) ThrowErrno(name_, "read", errno);
  if (!there || read != static_cast<std::ptrdiff_t>(count)) {
    ThrowError(name_, StrCat(SizeOf(file_, name_), " bytes"),
               StrCat(count, " from the byte ", offset));
  }
  return bytes;
}

std::vector<FeatureFile::Place> FeatureFile::ReadIndex(std::uint64_t offset,
                                                       std::size_t frames) const {
  const std::uint64_t index_bytes = frames * kPlaceBytes + kHashBytes;
  if (size_bytes_ < index_bytes || offset != size_bytes_ - index_bytes) {
    ThrowError(name_, StrCat(size_bytes_, " bytes"), StrCat(offset + index_bytes));
  }
  const std::string index = Read(offset, index_bytes);
  ByteReader reader(Checked(index, name_, "index"));
  std::vector<Place> places;
  std::uint64_t end = kHeaderBytes;
  for (std::size_t i = 0; i < frames; ++i) {
    const auto at = reader.Number<std::uint64_t>();
    const auto size_bytes = reader.Number<std::uint64_t>();
    places.push_back({at, size_bytes, std::string(reader.Take(kHashBytes))});
    if (at != end) ThrowError(name_, StrCat("frame ", i, " at byte ", at), StrCat(end));
    end += size_bytes;
  }
  if (end != offset) ThrowError(name_, StrCat("frames up to byte ", end), StrCat(offset));
  return places;
}

FrontEndFrame FeatureFile::Frame(std::size_t index) const {
  const Place& place = places_.at(index);
  const std::string bytes = Read(place.offset, place.size_bytes);
  if (Sha256Hex(bytes) != place.sha256) {
    ThrowError(name_, StrCat("damage in frame ", index), "the bytes that were written");
  }
  return DecodeFrame(bytes);
}

FeatureFileWriter::FeatureFileWriter(const std::filesystem::path& folder) : file_(folder) {
  file_.Append(std::string(kHeaderBytes, '\0'));
}

void FeatureFileWriter::Add(const FrontEndFrame& frame) {
  const std::string bytes = EncodeFrame(frame);
  AppendNumber(file_.size_bytes(), index_);
  AppendNumber(static_cast<std::uint64_t>(bytes.size()), index_);
  index_ += Sha256Hex(bytes);
  file_.Append(bytes);
  ++frames_;
}

std::uint64_t FeatureFileWriter::Complete(const std::string& key) {
  Require(key.size() == kHashBytes, "FeatureFileWriter: a key is a SHA-256");
  const std::string header = Encode({frames_, file_.size_bytes(), key});
  file_.Append(index_ + Sha256Hex(index_));
  file_.ReplaceStart(header);
  return file_.size_bytes();
}

}  // namespace cvo
