// Menus. Arrow keys move inside one, Escape closes it.

import { useLayoutEffect, useRef, useState } from "preact/hooks";

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

const isWithin = (place: EventTarget | null, inner: EventTarget | null) =>
  place instanceof Node && inner instanceof Node && place.contains(inner);

export interface MenuListProps {
  name: string;
  items: MenuItem[];
  /** Called for an item that is chosen: runs it, and closes the list. */
  onChoose: (item: MenuItem) => void;
  /** Called at Escape. */
  onClose: () => void;
  style?: Record<string, string | number>;
}

/** The open list. It takes the focus. */
export function MenuList({ name, items, onChoose, onClose, style }: MenuListProps) {
  const list = useRef<HTMLDivElement>(null);
  const reachable = () =>
    Array.from(list.current?.querySelectorAll<HTMLButtonElement>("button:not(:disabled)") ?? []);
  useLayoutEffect(() => reachable()[0]?.focus(), []);
  const step = (by: number) => {
    const all = reachable();
    const at = all.indexOf(document.activeElement as HTMLButtonElement);
    all[(at + by + all.length) % all.length]?.focus();
  };
  const key = (event: KeyboardEvent) => {
    if (!["ArrowDown", "ArrowUp", "Escape"].includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === "Escape") return onClose();
    step(event.key === "ArrowDown" ? 1 : -1);
  };
  return (
    <div ref={list} role="menu" aria-label={name} style={style} onKeyDown={key}>
      {items.map((item) => (
        <button
          key={item.label}
          type="button"
          class={item.divided ? "divided" : undefined}
          role={item.checked === undefined ? "menuitem" : "menuitemcheckbox"}
          aria-checked={item.checked}
          aria-label={item.label}
          disabled={item.disabled}
          onClick={() => onChoose(item)}
        >
          <span>{(item.checked ? "✓ " : "") + item.label + (item.what ? `: ${item.what}` : "")}</span>
          <span class="faint">{item.key}</span>
        </button>
      ))}
    </div>
  );
}

/** A menu of the bar. */
export function Menu({ name, items }: { name: string; items: MenuItem[] }) {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const close = () => {
    setOpen(false);
    button.current?.focus();
  };
  const choose = (item: MenuItem) => {
    close();
    item.run();
  };
  const key = (event: KeyboardEvent) => {
    if (open || !["ArrowDown", "ArrowUp"].includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    setOpen(true);
  };
  return (
    <div
      class="menu"
      onKeyDown={key}
      onFocusOut={(event) => !isWithin(event.currentTarget, event.relatedTarget) && setOpen(false)}
    >
      <button ref={button} type="button" aria-haspopup="menu" aria-expanded={open} onClick={() => setOpen(!open)}>
        {name}
      </button>
      {open && <MenuList {...{ name, items }} onChoose={choose} onClose={close} />}
    </div>
  );
}
