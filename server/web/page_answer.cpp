#include "server/web/page_answer.h"

#include <algorithm>

namespace burnish {
namespace {

// Nothing from elsewhere, nothing inline, in no frame of another page. 'wasm-unsafe-eval' lets
// WebAssembly be compiled, and no text become a script.
constexpr char kPolicy[] =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
    "img-src 'self' blob: data:; connect-src 'self'; worker-src 'self'; font-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

PageAnswer guarded(unsigned status) {
  PageAnswer answer;
  answer.status = status;
  answer.headers = {{"Content-Security-Policy", kPolicy},
                    {"X-Content-Type-Options", "nosniff"},
                    {"Referrer-Policy", "no-referrer"},
                    {"Cross-Origin-Opener-Policy", "same-origin"},
                    {"Cross-Origin-Embedder-Policy", "require-corp"},
                    {"Cross-Origin-Resource-Policy", "same-origin"}};
  return answer;
}

/// Returns whether a browser takes an encoding: the header lists names with weights.
bool takes(std::string_view accept_encoding, std::string_view encoding) {
  constexpr std::string_view kBetween = ", \t";
  for (size_t at = 0; at < accept_encoding.size();) {
    const size_t end = std::min(accept_encoding.find(',', at), accept_encoding.size());
    std::string_view each = accept_encoding.substr(at, end - at);
    at = end + 1;
    each.remove_prefix(std::min(each.find_first_not_of(kBetween), each.size()));
    if (!each.starts_with(encoding)) continue;
    each.remove_prefix(encoding.size());
    if (each.empty() || each[0] == ' ') return true;
    if (each[0] == ';') return !each.starts_with(";q=0") || each.starts_with(";q=0.");
  }
  return false;
}

void put_body(const WebFile& file, std::string_view accept_encoding, PageAnswer& answer) {
  const auto put = [&](std::string_view body, const char* encoding) {
    answer.body = body;
    answer.headers.emplace_back("Content-Encoding", encoding);
  };
  if (!file.brotli.empty() && takes(accept_encoding, "br")) return put(file.brotli, "br");
  if (takes(accept_encoding, "gzip")) return put(file.gzipped, "gzip");
  answer.body = file.bytes;
}

}  // namespace

PageAnswer answer_page(const WebFiles& files, const PageRequest& request) {
  if (request.method != "GET" && request.method != "HEAD") {
    PageAnswer answer = refuse_page(405, "use GET or HEAD\n");
    answer.headers.emplace_back("Allow", "GET, HEAD");
    return answer;
  }
  const WebFile* file = files.find(request.target);
  if (file == nullptr) return refuse_page(404, "there is no such page\n");
  const bool is_known = request.if_none_match.find(file->etag) != std::string_view::npos;
  PageAnswer answer = guarded(is_known ? 304 : 200);
  answer.headers.emplace_back("ETag", file->etag);
  answer.headers.emplace_back("Vary", "Accept-Encoding");
  answer.headers.emplace_back("Cache-Control",
                              file->is_immutable ? "max-age=31536000, immutable" : "no-cache");
  if (is_known) return answer;
  answer.headers.emplace_back("Content-Type", file->type);
  put_body(*file, request.accept_encoding, answer);
  return answer;
}

PageAnswer refuse_page(unsigned status, std::string_view reason) {
  PageAnswer answer = guarded(status);
  answer.headers.emplace_back("Content-Type", "text/plain; charset=utf-8");
  answer.headers.emplace_back("Cache-Control", "no-store");
  answer.body = reason;
  return answer;
}

}  // namespace burnish
