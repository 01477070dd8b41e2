// The browsers of the tests: Debian's.

import { existsSync } from "node:fs";
import { chromium, firefox, type Browser } from "playwright-core";

/**
 * `openGl`: Chromium with OpenGL on the processor, unless BURNISH_ANGLE names another way: gl-egl, vulkan.
 * `plain`: Chromium as it comes, on a machine without a graphics card.
 * `firefox`: Firefox ESR as it comes.
 */
export type BrowserKind = "openGl" | "plain" | "firefox";

const kAngle = process.env.BURNISH_ANGLE ?? "swiftshader";
const kSoftware = "--enable-unsafe-swiftshader";
const kOpenGl = ["--use-gl=angle", `--use-angle=${kAngle}`, kAngle === "swiftshader" ? kSoftware : "--ignore-gpu-blocklist"];
const kFlags = [
  "--no-sandbox",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
const kFirefox = process.env.BURNISH_FIREFOX ?? "/usr/bin/firefox-esr";

export const hasFirefox = existsSync(kFirefox);

function launchChromium(options: object): Promise<Browser> {
  return chromium.launch({ executablePath: process.env.BURNISH_CHROMIUM ?? "/usr/bin/chromium", ...options });
}

export function launchBrowser(kind: BrowserKind = "openGl"): Promise<Browser> {
  if (kind === "openGl") return launchChromium({ args: [...kFlags, ...kOpenGl] });
  // The driver of the tests asks for SwiftShader, which Chromium by itself does not take.
  if (kind === "plain") return launchChromium({ args: [...kFlags, "--disable-gpu"], ignoreDefaultArgs: [kSoftware] });
  return firefox.launch({ executablePath: kFirefox, channel: "moz-firefox" });
}
