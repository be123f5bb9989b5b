import { texts } from "../../i18n";

interface ComputerCodeProps {
  code: string;
}

/** What people compare of this PC's key before they approve it elsewhere. */
export function ComputerCode({ code }: ComputerCodeProps) {
  const { computer: say } = texts.value.teacher;
  return (
    <section class="panel card">
      <h2>{say.code}</h2>
      <code class="computer-code" data-testid="computer-code">
        {code}
      </code>
      <p class="labelled__hint">{say.codeHint}</p>
    </section>
  );
}
