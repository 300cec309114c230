// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// What this process has used so far. For reports only: no result may depend on it.
double CpuSeconds();           // all threads, user and system [s]
double PeakMemoryMegabytes();  // largest resident set [MB = 1e6 bytes]

}  // namespace radive
