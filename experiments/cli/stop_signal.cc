// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/stop_signal.h"

#include <csignal>

namespace cvo {
namespace {

// A global, because a signal handler can access nothing else.
volatile std::sig_atomic_t stop_requested = 0;

void NoteSignal(int) { stop_requested = 1; }

void Handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

StopSignal::StopSignal() {
  stop_requested = 0;
  Handle(NoteSignal);
}

StopSignal::~StopSignal() { Handle(SIG_DFL); }

bool StopSignal::Requested() const { return stop_requested != 0; }

}  // namespace cvo
