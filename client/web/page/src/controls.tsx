// Small parts that panels are made of.

import type { ComponentChildren } from "preact";
import { useEffect, useId, useState } from "preact/hooks";
import { keptTexts } from "./browser_store";
import { command } from "./commands";
import { useLink } from "./context";

/** A part of a column that folds. */
export function Section(props: { name: string; folded?: boolean; children: ComponentChildren }) {
  const key = "burnish.folded." + props.name;
  const kept = keptTexts.get(key);
  const [folded, setFolded] = useState(kept === null ? !!props.folded : kept === "yes");
  const id = useId();
  const toggle = () => {
    keptTexts.set(key, folded ? "no" : "yes");
    setFolded(!folded);
  };
  return (
    <section aria-label={props.name}>
      <h2>
        <button class="fold" aria-expanded={!folded} aria-controls={id} onClick={toggle}>
          {props.name}
        </button>
      </h2>
      <div id={id} class="panel" hidden={folded}>
        {!folded && props.children}
      </div>
    </section>
  );
}

export interface ButtonProps {
  label: string;
  onClick: () => void;
  hint?: string;
  /** Distinguishes buttons with the same label. */
  name?: string;
  pressed?: boolean;
  disabled?: boolean;
  class?: string;
}

export function Button({ label, name, hint, pressed, ...rest }: ButtonProps) {
  return (
    <button type="button" aria-label={name} title={hint} aria-pressed={pressed} {...rest}>
      {label}
    </button>
  );
}

export interface CheckProps {
  label: string;
  on: boolean;
  onChange: (on: boolean) => void;
  hint?: string;
  disabled?: boolean;
}

export function Check({ label, on, onChange, hint, disabled }: CheckProps) {
  return (
    <label class="check" title={hint}>
      <input
        type="checkbox"
        checked={on}
        disabled={disabled}
        onChange={(event) => {
          const wanted = event.currentTarget.checked;
          event.currentTarget.checked = on; // the model's answer switches it
          onChange(wanted);
        }}
      />
      {label}
    </label>
  );
}

export interface ChoiceProps<T extends string> {
  name: string;
  value: T;
  choices: readonly (readonly [T, string])[];
  onChange: (value: T) => void;
  disabled?: boolean;
  hint?: string;
  /** Shows the name in front. */
  labelled?: boolean;
}

export function Choice<T extends string>(props: ChoiceProps<T>) {
  const select = (
    <select
      aria-label={props.name}
      title={props.hint}
      value={props.value}
      disabled={props.disabled}
      onChange={(event) => props.onChange(event.currentTarget.value as T)}
    >
      {props.choices.map(([value, label]) => (
        <option key={value} value={value}>
          {label}
        </option>
      ))}
    </select>
  );
  if (!props.labelled) return select;
  return (
    <div class="labelled">
      <span aria-hidden="true">{props.name}</span>
      {select}
    </div>
  );
}

export const Row = (props: { children: ComponentChildren }) => <div class="row">{props.children}</div>;

export const Title = (props: { text: string; note?: string; hint?: string }) => (
  <div class="title" title={props.hint}>
    {props.text} <span class="faint">{props.note}</span>
  </div>
);

/** A text field with a button that takes its text. Enter takes it too, but not within an IME. */
export function NameField(props: {
  name: string;
  label: string;
  button: string;
  onTake: (text: string) => void;
  start?: string;
  disabled?: boolean;
  hint?: string;
  /** The text may be empty. */
  mayBeEmpty?: boolean;
}) {
  const [text, setText] = useState(props.start ?? "");
  const isRefused = (text: string) => props.disabled || (!props.mayBeEmpty && text.trim() === "");
  const take = (text: string) => {
    if (isRefused(text)) return;
    props.onTake(text.trim());
    setText("");
  };
  return (
    <div class="taker">
      <input
        type="text"
        aria-label={props.name}
        placeholder={props.label}
        value={text}
        maxLength={200}
        disabled={props.disabled}
        onInput={(event) => setText(event.currentTarget.value)}
        onKeyDown={(event) => {
          // The field's own text: a quick Enter comes before the next render.
          if (event.key === "Enter" && !event.isComposing) take(event.currentTarget.value);
        }}
      />
      <Button label={props.button} hint={props.hint} disabled={isRefused(text)} onClick={() => take(text)} />
    </div>
  );
}

/** Shows the region or the palette's curves over the surface while a panel is open. */
export function useOver(what: "protection" | "curves"): void {
  const link = useLink();
  useEffect(() => {
    link.send(command.over(what, true));
    return () => link.send(command.over(what, false));
  }, []);
}

/** Names and values in two columns. */
export const Figures = (props: { figures: { name: string; value: string }[] }) => (
  <dl class="figures">
    {props.figures.map((one) => (
      <div key={one.name}>
        <dt>{one.name}</dt>
        <dd>{one.value}</dd>
      </div>
    ))}
  </dl>
);
