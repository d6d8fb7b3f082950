// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/former_run.h"

#include <map>
#include <string>

#include "core/files/json/options_json.h"
#include "core/record/run_summary.h"
#include "experiments/cli/output_file.h"
#include "experiments/runner/identity.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

class FormerRun {
 public:
  explicit FormerRun(const fs::path& folder) : folder_(folder) {
    try {
      run_ = reports::ReadRun(folder / "result.json", {});
    } catch (const Error& error) {
      throw UsageError(StrCat(error.what(), "; use --force to replace it"));
    }
  }

  const reports::RunSummary& run() const { return run_; }

  [[noreturn]] void Refuse(const std::string& found, const std::string& expected) const {
    throw UsageError(StrCat(folder_.string(), ": found a run of ", run_.sequence.name, " with ",
                            found, ", expected ", expected, "; use --force to replace it"));
  }
  void ExpectSame(const std::string& what, const std::string& found,
                  const std::string& asked) const {
    if (found != asked) Refuse(StrCat(what, " ", found), asked);
  }

 private:
  fs::path folder_;
  reports::RunSummary run_;
};

void CheckOptions(const FormerRun& former, Options options) {
  const auto found = FlatJson(former.run().options);
  const Json json = OptionsToJson(OptionLeaves(options));
  for (const auto& [path, value] : FlatJson(ParseJson(DumpJson(json), "options"))) {
    const auto known = found.find(path);
    former.ExpectSame("option " + path, known == found.end() ? "not known" : known->second, value);
  }
}

}  // namespace

void CheckFormerRun(const RunRequest& request, const fs::path& folder) {
  if (!fs::exists(folder / "result.json")) return;
  const FormerRun former(folder);
  const reports::RunSummary& run = former.run();
  const Sequence& sequence = request.sequence;
  const auto end = sequence.first_frame + static_cast<int>(sequence.images.size());
  former.ExpectSame("sequence", run.sequence.name, sequence.name);
  former.ExpectSame("frames", StrCat(run.sequence.first_frame, ":", run.sequence.range().last + 1),
                    StrCat(sequence.first_frame, ":", end));
  former.ExpectSame("variant", run.variant, std::string(request.variant.name));
  former.ExpectSame("seed", StrCat(run.seed), StrCat(request.seed));
  CheckOptions(former, request.options);
  if (run.sequence.detections_hash != DetectionsHash(sequence)) {
    former.Refuse(StrCat("other detections (", run.sequence.detections, ")"),
                  StrCat("the given ones (", sequence.detections.size(), ")"));
  }
  former.ExpectSame("classes and oracles", run.given.dump(),
                    Given(sequence, request.classes, request.oracle).dump());
  if (!request.landmarks && fs::exists(folder / "landmarks.csv")) {
    former.Refuse("landmarks.csv", "one without, or --landmarks");
  }
  const auto& hashes = request.images;
  if (run.sequence.content == ContentHash(sequence, hashes.empty() ? HashImages(sequence) : hashes))
    return;
  former.Refuse("other images, calibration or ground truth", "the given ones");
}

}  // namespace cvo
