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
  const selectAll = () => field.current === window.document.activeElement && field.current?.select();
  useLayoutEffect(() => {
    awaitsAnswer.current = false;
    if (!isTyping.current) selectAll();
  }, [shown]);
  const forget = () => {
    isTyping.current = false;
    field.current!.value = shown;
    setTyped(null);
    selectAll();
  };
  const take = () => {
    const text = field.current!.value;
    const isAnother = isTyping.current && (text !== shown || awaitsAnswer.current);
    forget();
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
      onFocus={selectAll}
      onInput={(event) => {
        isTyping.current = true;
        setTyped(event.currentTarget.value);
      }}
      onBlur={take}
      onKeyDown={(event) => {
        if (event.key === "Enter" && !event.isComposing) take();
        if (event.key === "Escape") forget();
      }}
    />
  );
}
