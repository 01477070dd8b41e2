#pragma once

#include <memory>

#include <grpcpp/security/server_credentials.h>

#include "server/rpc/admission/admission.h"
#include "server/trust/certificates.h"
#include "server/trust/reloaded.h"

namespace burnish {

/// Security of connections. Both kinds let calls in through `admission`. Needs: `certificates`
/// outlives the server.

/// TLS; every handshake uses the certificates of that moment. With a client CA clients show one of
/// its certificates: all clients, or those that have one.
std::shared_ptr<grpc::ServerCredentials> tls_credentials(
    const Reloaded<Certificates>& certificates, bool client_certificate_required,
    std::shared_ptr<const Admission> admission);

std::shared_ptr<grpc::ServerCredentials> plaintext_credentials(
    std::shared_ptr<const Admission> admission);

/// Sends gRPC's own errors to the server's log: only they report failed handshakes.
void adopt_grpc_log();

}  // namespace burnish
