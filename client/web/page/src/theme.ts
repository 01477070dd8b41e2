// Dark or light: as the browser says, until the user chooses.

import { keptTexts } from "./browser_store";

export type Theme = "system" | "dark" | "light";

const kTheme = "burnish.theme";

export function chosenTheme(): Theme {
  const kept = keptTexts.get(kTheme);
  return kept === "dark" || kept === "light" ? kept : "system";
}

export function applyTheme(theme = chosenTheme()): void {
  document.documentElement.dataset.theme = theme;
}

export function chooseTheme(theme: Theme): void {
  keptTexts.set(kTheme, theme);
  applyTheme();
}
