// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo crf.
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/clustering/unary_terms.h"
#include "core/files/json/options_json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/run.h"
#include "experiments/datasets/images.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/build_plan.h"
#include "reports/overlays/canvas.h"
#include "reports/overlays/draw_overlay.h"
#include "synth/write/render_cache.h"
#include "variants/registry.h"

namespace cvo {
namespace {

// Terms and a kernel of the CRF that are tried on the frames of a run. No label is passed on: the
// run goes its own way, so all trials see the same points, boxes and bodies.
struct CrfTrial {
  std::string name;
  EnergyMatrix (*energies)(const CrfScene&, const UnaryOptions&);
  CrfResult (*infer)(const CrfMatrix&, const Eigen::Matrix3Xd&, const PairwiseOptions&, CrfMemory&);
};

template <typename Kernel, typename... Terms>
CrfTrial Trial(const char* name) {
  return {name, &ComputeUnaries<Terms...>, &InferDenseCrf<Kernel>};
}

// A new term or kernel is a policy beside the others (unary_terms.h, dense_crf.h) and a line here.
const std::vector<CrfTrial>& Trials() {
  static const std::vector<CrfTrial> kTrials = {
      Trial<NoPairwise, Box2dTerm>("2D"),
      Trial<NoPairwise, Box2dTerm, AffinityTerm>("2D+3D"),
      Trial<NoPairwise, Box2dTerm, AffinityTerm, MotionTerm>("2D+3D+motion"),
      Trial<NoPairwise, AffinityTerm>("3D"),
      Trial<NoPairwise, MotionTerm>("motion"),
      Trial<NormalizedGaussianKernel, Box2dTerm, AffinityTerm, MotionTerm>("all, kernel"),
      Trial<RawGaussianKernel, Box2dTerm, AffinityTerm, MotionTerm>("all, printed kernel"),
      Trial<NoPairwise, Box2dTermLiteral, AffinityTermLiteral>("printed 2D+3D"),
      Trial<RawGaussianKernel, Box2dTermLiteral, AffinityTermLiteral, MotionTerm>("printed, all")};
  return kTrials;
}
constexpr std::size_t kDrawn = 3;  // the first trials: the paper's figure

// Returns the landmarks of a frame with the labels of a trial. A new box is a cluster that no body
// has; without a CRF, all landmarks are static.
std::vector<LandmarkReport> Label(const CrfTrial& trial, const Options& options,
                                  const FrameReport& report, CrfMemory& memory) {
  constexpr std::int64_t kFirstNewBox = 1000000;  // above all clusters
  std::vector<LandmarkReport> landmarks = report.landmarks;
  for (LandmarkReport& landmark : landmarks) landmark.cluster = kStaticScene;
  const CrfScene& scene = report.crf;
  if (scene.nodes.empty()) return landmarks;
  Require(scene.nodes.size() == landmarks.size(), "crf: one node per landmark");
  const CrfResult result = trial.infer(trial.energies(scene, options.unary), MovingPlaces(scene),
                                       options.pairwise, memory);
  const std::vector<int> labels = MostLikelyLabels(result.q);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const CrfLabel& label = scene.labels[static_cast<std::size_t>(labels[i])];
    landmarks[i].cluster =
        label.kind == LabelKind::kNewBox ? ClusterId{kFirstNewBox + labels[i]} : label.cluster;
  }
  return landmarks;
}

struct Flags {
  SequenceFlags sequence;
  std::vector<std::string> folders;
  std::string variant = "full";
  std::vector<std::string> set;
  int figure = -1;
  std::string output;
  int threads = 1;
  bool quiet = false;
};

// The landmarks in the colours of their labels, and the boxes.
cv::Mat Draw(const Sequence& sequence, const std::string& name, const EstimatedFrame& seen,
             const std::vector<LandmarkReport>& labelled) {
  reports::OverlayFrame frame;
  for (const Detection& detection : seen.record.detections) {
    frame.detections.push_back(detection.box);
  }
  for (const LandmarkReport& landmark : labelled) {
    const auto& z_px = seen.given.features[static_cast<std::size_t>(landmark.feature)].z_px;
    frame.landmarks.push_back(
        {static_cast<float>(z_px[0]), static_cast<float>(z_px[1]),
         landmark.cluster.valid() ? landmark.cluster.value : reports::kOutlierLabel});
  }
  const reports::CameraInfo camera{.width_px = sequence.camera.width_px,
                                   .height_px = sequence.camera.height_px};
  reports::OverlayStyle style = reports::StyleFor(camera, camera.width_px);
  style.plain = true;
  const auto index = static_cast<std::size_t>(seen.record.frame - sequence.first_frame);
  const cv::Mat left = LoadFrameImage(sequence, index, 0).grey;
  reports::Canvas canvas{reports::DrawOverlay(left, frame, camera, style)};
  reports::DrawPlate(name, {0, 0}, style.text_px, reports::kDark, canvas);
  return canvas.pixels;
}

// The scores of what labelled the landmarks: values of a metric, one per sequence that has it.
using Scores = std::vector<std::map<std::string, std::vector<double>>>;

void AddScores(const ObjectTruth& truth, const ObjectEstimate& estimate,
               const std::vector<ObjectMatch>& matches, std::size_t row, Scores& scores) {
  for (const Metric& metric : ClusteringMetrics(truth, estimate, matches)) {
    scores[row][metric.name].push_back(metric.value);
  }
}

struct Scene {
  Sequence sequence;
  std::unique_ptr<BodyTruthReader> truth;
};

Scene OpenScene(const std::string& folder, const Flags& flags) {
  SequenceFlags selected = flags.sequence;
  selected.folder = folder;
  Scene scene{OpenSequence(WithBoxes(selected.Request(flags.quiet))), nullptr};
  RequireAsRendered(scene.sequence);
  scene.truth = ReadBodyTruth(scene.sequence);
  if (!scene.truth || !scene.truth->objects().tells_pixels) {
    ThrowError(folder, "no ground truth of the bodies at pixels", "a rendered scene");
  }
  const int first = scene.sequence.first_frame;
  const int last = first + static_cast<int>(scene.sequence.images.size()) - 1;
  if (flags.figure >= 0 && (flags.figure < first || flags.figure > last)) {
    ThrowError(folder, StrCat("no frame ", flags.figure), StrCat("frames ", first, " to ", last));
  }
  return scene;
}

// Runs the variant on a sequence, tries all trials on its frames, and adds their scores, the run's
// own first, and the pictures of the frame that is drawn. Returns false if it was stopped.
bool TryOn(const Scene& scene, const Flags& flags, Scores& scores, std::vector<cv::Mat>& pictures) {
  const Sequence& sequence = scene.sequence;
  const VariantInfo& variant = FindVariant(flags.variant);
  const StopSignal stop;
  Progress progress(flags.quiet);
  RunRequest request = {.sequence = sequence,
                        .variant = variant,
                        .options = ResolveOptions<Options>("", flags.set, variant.defaults()),
                        .threads = flags.threads,
                        .stop = [&stop] { return stop.Requested(); }};
  request.progress = [&](std::size_t done) {
    progress.Report(done, sequence.images.size(), sequence.name);
  };
  std::vector<std::vector<std::vector<LandmarkObservation>>> observed(Trials().size());
  CrfMemory memory;
  const auto run = RunSequence(request, scene.truth.get(), [&](const EstimatedFrame& seen) {
    for (std::size_t i = 0; i < observed.size(); ++i) {
      const CrfTrial& trial = Trials()[i];
      const auto labelled = Label(trial, request.options, seen.record.report, memory);
      observed[i].push_back(CountLandmarks(labelled, seen.feature_truth));
      if (seen.record.frame != flags.figure || i >= kDrawn) continue;
      pictures.push_back(Draw(sequence, trial.name, seen, labelled));
    }
  });
  if (!run) return false;
  if (run->status == RunStatus::kFailed) throw Error(run->message);
  const ObjectTruth& truth = scene.truth->objects();
  ObjectEstimate estimate = ObjectEstimateOf(*run, reports::PoseTime::kCausal);
  const std::vector<ObjectMatch> matches = MatchObjects(truth, estimate);
  AddScores(truth, estimate, matches, 0, scores);
  for (std::size_t i = 0; i < observed.size(); ++i) {
    estimate.landmarks = std::move(observed[i]);
    AddScores(truth, estimate, matches, i + 1, scores);
  }
  return true;
}

// Prints means over the sequences.
void PrintScores(const Scores& scores) {
  TextTable table({"labels by", "moving precision", "moving recall", "clustering IoU"});
  for (std::size_t row = 0; row < scores.size(); ++row) {
    std::vector<std::string> cells = {row == 0 ? "run" : Trials()[row - 1].name};
    for (const char* metric : {"moving_precision", "moving_recall", "clustering_iou"}) {
      const auto found = scores[row].find(metric);
      cells.push_back(found == scores[row].end() ? "-" : ReadableNumber(MeanOf(found->second)));
    }
    table.Add(cells);
  }
  table.Print(std::cout);
}

int TryAll(const Flags& flags) {
  if ((flags.figure >= 0) == flags.output.empty()) {
    throw UsageError("--figure and -o: found one of them, expected both or none");
  }
  const std::vector<std::filesystem::path> read(flags.folders.begin(), flags.folders.end());
  if (!flags.output.empty()) CheckOutputFile(flags.output, read);
  Scores scores(Trials().size() + 1);
  std::vector<cv::Mat> pictures;
  std::vector<Scene> scenes;  // all of them, before the minutes of the first
  for (const std::string& folder : flags.folders) scenes.push_back(OpenScene(folder, flags));
  for (const Scene& scene : scenes) {
    if (!TryOn(scene, flags, scores, pictures)) return kInterrupted;
  }
  PrintScores(scores);
  if (flags.output.empty()) return 0;
  WriteOutputFile(flags.output, reports::PngBytes(reports::Grid(pictures, kDrawn)), read);
  std::cout << "written: " << flags.output << '\n';
  return 0;
}

}  // namespace

Command AddCrfCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "crf", "Try terms and kernels of the CRF on the frames of a run, without effect on the run");
  const auto flags = std::make_shared<Flags>();
  const FlagAdder add{*app};
  add("SEQUENCE", flags->folders, "", "folders of rendered scenes")->required();
  add("--frames", flags->sequence.frames, "A:B", "frames A to B-1, counted from 0; default: all");
  add("--detections", flags->sequence.detections_file, "LEVEL", "detector level; default: good");
  AddEstimator(*app, flags->variant, flags->set);
  add("--figure", flags->figure, "N",
      "draw the labels by 2D, 2D+3D and 2D+3D+motion in frame N side by side, as the paper does")
      ->check(CLI::NonNegativeNumber.description(""));
  add("-o,--output", flags->output, "FILE", "where to write the figure, a PNG file");
  AddThreads(*app, flags->threads);
  AddQuiet(*app, flags->quiet);
  app->footer(
      "The variant runs once on each sequence, and each trial labels the same points with the same "
      "boxes\nand bodies in every frame. Rows: the labels that the run adopted; sums of unary "
      "terms; all terms\nwith a kernel; the terms as printed in the paper. Metrics are those of "
      "clustervo run, as means over\nthe sequences. Outliers do not move; a new box is a body of "
      "its own.\n"
      "Examples:\n"
      "  clustervo crf indoor_1 --frames 0:50\n"
      "  clustervo crf indoor_1 --frames 0:50 --set unary.eta=0.8 --figure 40 -o terms.png");
  return {app, [flags] { return TryAll(*flags); }};
}

}  // namespace cvo
