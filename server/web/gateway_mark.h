#pragma once

namespace burnish {

/// Metadata with which the web gateway marks its calls inside the process. gRPC knows neither the
/// address nor the certificate of the gateway's clients. The server believes both only beside the
/// secret, and no call of gRPC's own clients can have that.
inline constexpr char kGatewaySecretKey[] = "burnish-gateway-secret";
inline constexpr char kGatewayPeerKey[] = "burnish-gateway-peer";
inline constexpr char kGatewayCertificateKey[] =
    "burnish-gateway-certificate-bin";  ///< a common name

}  // namespace burnish
