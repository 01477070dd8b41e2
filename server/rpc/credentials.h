#pragma once

#include <memory>

#include <grpcpp/security/server_credentials.h>

#include "server/rpc/admission.h"
#include "server/trust/certificates.h"
#include "server/trust/reloaded.h"

namespace burnish {

/// How connections are secured. Of both kinds `admission` lets the calls in.
/// Needs: `certificates` outlives the server.

/// TLS; every handshake uses the certificates as they are then. With a client CA clients show a
/// certificate of it: all of them, or those who have one.
std::shared_ptr<grpc::ServerCredentials> tls_credentials(
    const Reloaded<Certificates>& certificates, bool client_certificate_required,
    std::shared_ptr<const Admission> admission);

std::shared_ptr<grpc::ServerCredentials> plaintext_credentials(
    std::shared_ptr<const Admission> admission);

/// Sends gRPC's own errors to our log: nothing else tells of handshakes that fail.
void adopt_grpc_log();

}  // namespace burnish
