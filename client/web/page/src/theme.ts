// Dark or light: as the browser says, until the user chooses.

export type Theme = "system" | "dark" | "light";

const kTheme = "burnish.theme";

export function chosenTheme(): Theme {
  const kept = localStorage.getItem(kTheme);
  return kept === "dark" || kept === "light" ? kept : "system";
}

export function applyTheme(theme = chosenTheme()): void {
  document.documentElement.dataset.theme = theme;
}

export function chooseTheme(theme: Theme): void {
  localStorage.setItem(kTheme, theme);
  applyTheme();
}
