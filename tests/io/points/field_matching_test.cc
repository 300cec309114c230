// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/field_matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace radive {
namespace {

using ::testing::HasSubstr;

std::vector<PointField> Fields(const std::vector<std::string>& names) {
  PointTable table;
  for (const std::string& name : names) table.AddField(name, NumericType::kFloat32);
  return table.fields;
}

// Name of the field that got the role; "" for none, "?" when the fields do not match at all.
std::string Found(FieldRole role,
                  const std::vector<std::string>& names,
                  const std::string& choices = "") {
  std::string error;
  const auto parsed = ParseFieldChoices(choices, &error);
  if (!parsed) return "?";
  const auto match = MatchFields(Fields(names), *parsed, &error);
  if (!match) return "?";
  const int index = (*match)[role];
  return index < 0 ? "" : names[static_cast<std::size_t>(index)];
}

TEST(MatchFields, FindsTheDopplerOfEachDataset) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      // SNAIL Oculii: the compensated recoveredSpeed and dopplerAccu are no Doppler.
      {{"x", "y", "z", "recoveredSpeed", "dopplerAccu", "Doppler", "Range", "Power"}, "Doppler"},
      {{"x", "y", "z", "snr_db", "v_doppler_mps", "noise_db", "range"}, "v_doppler_mps"},
      {{"x", "y", "z", "v_r_compensated", "v_r"}, "v_r"},
      {{"x", "y", "z", "intensity", "velocity"}, "velocity"},
      {{"x", "y", "z", "vel", "v", "doppler_std"}, "v"},
      {{"x", "y", "z", "speed", "rangeRate"}, "rangeRate"},
      {{"x", "y", "z", "scalar_Doppler", "scalar_v"}, "scalar_Doppler"},
      {{"x", "y", "z", "vx", "vy", "vx_comp", "adjusted_doppler", "doppler_bin"}, ""},
  };
  for (const auto& [names, doppler] : cases) EXPECT_EQ(Found(FieldRole::kDoppler, names), doppler);
}

TEST(MatchFields, TakesThePowerByPriorityNotByPosition) {
  EXPECT_EQ(Found(FieldRole::kPower, {"x", "y", "z", "RCS", "intensity", "SNR"}), "SNR");
  EXPECT_EQ(Found(FieldRole::kPower, {"reflectivity", "z", "y", "x"}), "reflectivity");
  EXPECT_EQ(Found(FieldRole::kTime, {"x", "y", "z", "time_offset_ns"}), "time_offset_ns");
}

TEST(MatchFields, ChoicesWin) {
  const std::vector<std::string> names = {"x", "y", "z", "Doppler", "vel_r", "snr", "rcs"};
  EXPECT_EQ(Found(FieldRole::kDoppler, names, "[doppler=vel_r, power=rcs]"), "vel_r");
  EXPECT_EQ(Found(FieldRole::kPower, names, "doppler=VEL_R,power=rcs"), "rcs");
  EXPECT_EQ(Found(FieldRole::kDoppler, names, "[doppler=_]"), "");
  EXPECT_EQ(Found(FieldRole::kX, {"east", "north", "up"}, "x=east,y=north,z=up"), "east");
}

TEST(MatchFields, NamesTheFieldsThatAreThereWhenPositionsAreMissing) {
  std::string error;
  EXPECT_FALSE(MatchFields(Fields({"east", "y", "Doppler"}), {}, &error));
  EXPECT_THAT(error, HasSubstr("expected the fields x, y and z"));
  EXPECT_THAT(error, HasSubstr("found 'east', 'y', 'Doppler'"));
  EXPECT_FALSE(MatchFields(Fields({"x", "y"}), {{FieldRole::kDoppler, "velo"}}, &error));
  EXPECT_THAT(error, HasSubstr("there is no field 'velo' (input.fields: doppler=velo)"));
  EXPECT_FALSE(MatchFields({}, {}, &error));
  EXPECT_THAT(error, HasSubstr("found none"));
}

TEST(ParseFieldChoices, SaysWhatIsWrong) {
  for (const char* text : {"doppler", "speed=v", "doppler=", "[doppler=v,,]"}) {
    std::string error;
    EXPECT_FALSE(ParseFieldChoices(text, &error)) << text;
    EXPECT_THAT(error, HasSubstr("expected a list like [doppler=vel_r, power=snr]"));
  }
}

// Factors by hand: 1 deg = pi/180 rad, 3.6 km/h = 1 m/s.
TEST(FieldMatching, UnitsBehindTheNames) {
  const auto unit = [](const char* name) {
    const std::optional<FieldRole> role = RoleOfName(name);
    return role ? UnitOfName(*role, name) : -1.0;
  };
  for (const char* name : {"x [m]",
                           "X(m)",
                           "y_m",
                           "z [meters]",
                           "range_m",
                           "velocity [m/s]",
                           "azimuth [rad]",
                           "rcs [dBsm]",
                           "snr (dB)",
                           "power [a.u.]",
                           "doppler"}) {
    EXPECT_EQ(unit(name), 1.0) << name;
  }
  EXPECT_EQ(unit("x [mm]"), 1e-3);
  EXPECT_EQ(unit("range_cm"), 1e-2);
  EXPECT_NEAR(unit("v_r [km/h]"), 0.277777777777778, 1e-15);
  EXPECT_NEAR(unit("azimuth_deg"), 0.0174532925199433, 1e-15);
  EXPECT_NEAR(unit("elevation [\xC2\xB0]"), 0.0174532925199433, 1e-15);
  for (const char* name : {"x [bins]", "velocity [m]", "doppler_bin", "x_y", "azimuth [m]"}) {
    EXPECT_EQ(unit(name), -1.0) << name;
  }
  EXPECT_EQ(RoleOfName("Velocity (km/h)"), FieldRole::kDoppler);
}

}  // namespace
}  // namespace radive
