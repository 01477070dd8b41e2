// The menu bar. Arrow keys move inside a menu, Escape closes it.

import { useEffect, useRef, useState } from "preact/hooks";

export interface MenuItem {
  label: string;
  /** What it does it to, behind the label. */
  what?: string;
  key?: string;
  disabled?: boolean;
  /** Present for what is on or off. */
  checked?: boolean;
  /** Draws a line before it. */
  divided?: boolean;
  run: () => void;
}

export function Menu({ name, items }: { name: string; items: MenuItem[] }) {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLDivElement>(null);
  const reachable = () =>
    Array.from(list.current?.querySelectorAll<HTMLButtonElement>("button:not(:disabled)") ?? []);
  useEffect(() => {
    if (open) reachable()[0]?.focus();
  }, [open]);
  const close = () => {
    setOpen(false);
    button.current?.focus();
  };
  const step = (by: number) => {
    const all = reachable();
    const at = all.indexOf(document.activeElement as HTMLButtonElement);
    all[(at + by + all.length) % all.length]?.focus();
  };
  const key = (event: KeyboardEvent) => {
    if (!["ArrowDown", "ArrowUp", "Escape"].includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === "Escape") return close();
    if (open) step(event.key === "ArrowDown" ? 1 : -1);
    else setOpen(true);
  };
  const leave = (event: FocusEvent) => {
    const to = event.relatedTarget;
    if (!(to instanceof Node && (event.currentTarget as HTMLElement).contains(to))) setOpen(false);
  };
  return (
    <div class="menu" onKeyDown={key} onFocusOut={leave}>
      <button ref={button} type="button" aria-haspopup="menu" aria-expanded={open} onClick={() => setOpen(!open)}>
        {name}
      </button>
      {open && (
        <div ref={list} role="menu" aria-label={name}>
          {items.map((item) => (
            <button
              key={item.label}
              type="button"
              class={item.divided ? "divided" : undefined}
              role={item.checked === undefined ? "menuitem" : "menuitemcheckbox"}
              aria-checked={item.checked}
              aria-label={item.label}
              disabled={item.disabled}
              onClick={() => {
                close();
                item.run();
              }}
            >
              <span>{(item.checked ? "✓ " : "") + item.label + (item.what ? `: ${item.what}` : "")}</span>
              <span class="faint">{item.key}</span>
            </button>
          ))}
        </div>
      )}
    </div>
  );
}
