#include "common/sheets/chart_codec.h"

#include <bit>
#include <numeric>
#include <string>

#include "common/packing/byte_planes.h"
#include "common/packing/zstd_frame.h"
#include "common/sheets/sheet_checks.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "charts are written as they lie");

constexpr int kChartZstdLevel = 5;
constexpr size_t kBytesPerChart = 14;  // of all columns

/// The columns of the charts' numbers, in the order of the format.
struct ChartColumns {
  std::array<std::vector<uint16_t>, 3> codes;  // normal u, normal v, angle
  std::array<std::vector<uint32_t>, 2> corners;
};

ChartColumns columns_of(const PageCharts& charts) {
  ChartColumns columns;
  for (const Chart& chart : charts.charts) {
    for (int k = 0; k < 2; ++k) {
      columns.codes[k].push_back(static_cast<uint16_t>(chart.normal[k]));
      columns.corners[k].push_back(static_cast<uint32_t>(chart.least[k]));
    }
    columns.codes[2].push_back(chart.angle);
  }
  return columns;
}

/// Takes the columns off the body. Needs: the body has them.
std::vector<Chart> read_columns(std::span<const uint8_t> body, size_t count) {
  ChartColumns columns;
  for (auto& codes : columns.codes) {
    codes.resize(count);
    read_planes<uint16_t>(body.first(2 * count), 2, codes);
    body = body.subspan(2 * count);
  }
  for (auto& corners : columns.corners) {
    corners.resize(count);
    read_planes<uint32_t>(body.first(4 * count), 4, corners);
    body = body.subspan(4 * count);
  }
  std::vector<Chart> charts(count);
  for (size_t c = 0; c < count; ++c) {
    for (int k = 0; k < 2; ++k) {
      charts[c].normal[k] = static_cast<int16_t>(columns.codes[k][c]);
      charts[c].least[k] = static_cast<int32_t>(columns.corners[k][c]);
    }
    charts[c].angle = columns.codes[2][c];
  }
  return charts;
}

Status check_chart_header(const ChartHeader& header, const Page& page) {
  if (header.page != page.id)
    return data_loss("the page is " + std::to_string(header.page) + ", not " +
                     std::to_string(page.id));
  if (header.zero != std::array<uint8_t, 3>{}) return data_loss("reserved bits are set");
  const size_t triangles = page.triangles.size();
  RETURN_IF_ERROR(check_sheet_value("charts", header.charts, 1, triangles));
  return check_sheet_value("named charts", header.named, header.charts, triangles);
}

/// Fails: data_loss if a turn names the same chart again, or turns name another number of charts.
Result<std::vector<uint16_t>> follow_turns(std::span<const uint8_t> turns,
                                           std::span<const uint16_t> named) {
  const auto count = std::accumulate(turns.begin(), turns.end(), size_t{0});
  RETURN_IF_ERROR(check_sheet_value("turns that name a chart", count, named.size(), named.size()));
  if (turns[0] == 0) return data_loss("the first triangle does not name its chart");
  std::vector<uint16_t> of_triangle;
  size_t next = 0;
  for (size_t t = 0; t < turns.size(); ++t) {
    const uint16_t chart = turns[t] != 0 ? named[next++] : of_triangle.back();
    if (t > 0 && turns[t] != 0 && chart == of_triangle.back())
      return data_loss("triangle " + std::to_string(t) + " names chart " + std::to_string(chart) +
                       ", which the triangle before has");
    of_triangle.push_back(chart);
  }
  return of_triangle;
}

Status check_normal_codes(std::span<const Chart> charts) {
  for (size_t c = 0; c < charts.size(); ++c)
    for (const int code : charts[c].normal)
      if (code < -kChartNormalLimit)
        return data_loss("chart " + std::to_string(c) + " has a normal of " + std::to_string(code) +
                         ", the least is " + std::to_string(-kChartNormalLimit));
  return Status::ok();
}

Result<PageCharts> decode_charts_of(std::span<const uint8_t> bytes, const Page& page) {
  ASSIGN_OR_RETURN(const auto header, read_sealed<ChartHeader>(bytes, kChartBytesMax));
  RETURN_IF_ERROR(check_chart_header(header, page));
  const size_t turn_bytes = (page.triangles.size() + 7) / 8;
  const size_t named_bytes = size_t{2} * header.named;
  ASSIGN_OR_RETURN(const auto body,
                   decompress(bytes.subspan(sizeof(header)),
                              turn_bytes + named_bytes + kBytesPerChart * header.charts));
  const std::span<const uint8_t> sections = body;
  std::vector<uint8_t> turns(page.triangles.size());
  read_bits(sections, turns);
  std::vector<uint16_t> named(header.named);
  read_planes<uint16_t>(sections.subspan(turn_bytes, named_bytes), 2, named);
  PageCharts charts{.charts =
                        read_columns(sections.subspan(turn_bytes + named_bytes), header.charts)};
  ASSIGN_OR_RETURN(charts.of_triangle, follow_turns(turns, named));
  RETURN_IF_ERROR(check_normal_codes(charts.charts));
  const Status checked = check_charts(page, charts);
  if (!checked.is_ok()) return data_loss(checked.message());
  return charts;
}

}  // namespace

std::vector<uint8_t> encode_charts(PageId page, const PageCharts& charts) {
  std::vector<uint8_t> turns;
  std::vector<uint16_t> named;
  for (size_t t = 0; t < charts.of_triangle.size(); ++t) {
    const bool names = t == 0 || charts.of_triangle[t] != charts.of_triangle[t - 1];
    turns.push_back(names ? 1 : 0);
    if (names) named.push_back(charts.of_triangle[t]);
  }
  std::vector<uint8_t> body;
  append_bits(turns, body);
  append_planes<uint16_t>(named, 2, body);
  const ChartColumns columns = columns_of(charts);
  for (const auto& codes : columns.codes) append_planes<uint16_t>(codes, 2, body);
  for (const auto& corners : columns.corners) append_planes<uint32_t>(corners, 4, body);
  std::vector<uint8_t> bytes(kChartHeaderBytes);
  append_compressed(body, kChartZstdLevel, bytes);
  seal_record(ChartHeader{.page = page,
                          .charts = static_cast<uint16_t>(charts.charts.size()),
                          .named = static_cast<uint16_t>(named.size())},
              bytes);
  return bytes;
}

Result<PageCharts> decode_charts(std::span<const uint8_t> bytes, const Page& page) {
  auto charts = decode_charts_of(bytes, page);
  if (!charts.is_ok())
    return charts.status().with_context("charts of page " + std::to_string(page.id));
  return charts;
}

}  // namespace burnish
