// A text field that shows a value of the session until something is typed.

import { useLayoutEffect, useRef, useState } from "preact/hooks";

export interface TypedFieldProps {
  name: string;
  shown: string;
  /** Called with what was typed, at Enter or when the user leaves the field. Escape gives it up. */
  onTake: (text: string) => void;
  class?: string;
  inputMode?: "decimal";
  placeholder?: string;
  title?: string;
  disabled?: boolean;
}

// The field's own text counts, not that of the last render: a quick key comes before the next one.
export function TypedField({ name, shown, onTake, ...rest }: TypedFieldProps) {
  const field = useRef<HTMLInputElement>(null);
  const [typed, setTyped] = useState<string | null>(null);
  const isTyping = useRef(false);
  const awaitsAnswer = useRef(false); // what is shown may be older than what was taken
  // Text that was set has no selection: what is typed next would stand behind it.
  const selectAll = (input: HTMLInputElement) => input === window.document.activeElement && input.select();
  useLayoutEffect(() => {
    awaitsAnswer.current = false;
    if (!isTyping.current) selectAll(field.current!);
  }, [shown]);
  const forget = (input: HTMLInputElement) => {
    isTyping.current = false;
    input.value = shown;
    setTyped(null);
    selectAll(input);
  };
  const take = (input: HTMLInputElement) => {
    const text = input.value;
    const isAnother = isTyping.current && (text !== shown || awaitsAnswer.current);
    forget(input);
    if (!isAnother) return;
    awaitsAnswer.current = true;
    onTake(text);
  };
  return (
    <input
      {...rest}
      ref={field}
      type="text"
      aria-label={name}
      value={typed ?? shown}
      onFocus={(event) => selectAll(event.currentTarget)}
      onInput={(event) => {
        isTyping.current = true;
        setTyped(event.currentTarget.value);
      }}
      onBlur={(event) => take(event.currentTarget)}
      onKeyDown={(event) => {
        if (event.key === "Enter" && !event.isComposing) take(event.currentTarget);
        if (event.key === "Escape") forget(event.currentTarget);
      }}
    />
  );
}
