// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app_main.h"

DEFINE_string(reference, "", "Trajectory that counts as true. Required.");

int main(int argc, char** argv) {
  radive::InitApp(&argc,
                  &argv,
                  "Errors of an estimated trajectory.\n"
                  "  radive_evaluate --reference=REFERENCE --estimate=ESTIMATE");
  return EXIT_SUCCESS;
}
