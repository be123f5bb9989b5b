import type { FormHTMLAttributes } from "preact";
import { settled } from "./report";

interface FormProps extends Omit<FormHTMLAttributes<HTMLFormElement>, "onSubmit"> {
  testId?: string;
  "data-testid"?: never;
  /** May return a promise; its failure is reported. */
  onSubmit(): unknown;
}

/** A form that scripts submit and validate, not the browser. */
export function Form({ testId, onSubmit, ...rest }: FormProps) {
  return (
    <form
      {...rest}
      data-testid={testId}
      noValidate
      onSubmit={(event) => {
        event.preventDefault();
        void settled(onSubmit());
      }}
    />
  );
}
