#include "server/web/page_answer.h"

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

bool takes_gzip(std::string_view accept_encoding) {
  const size_t at = accept_encoding.find("gzip");
  return at != std::string_view::npos && !accept_encoding.substr(at).starts_with("gzip;q=0");
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
  answer.body = file->bytes;
  if (takes_gzip(request.accept_encoding)) {
    answer.headers.emplace_back("Content-Encoding", "gzip");
    answer.body = file->gzipped;
  }
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
