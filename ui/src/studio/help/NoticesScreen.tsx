import { ArrowLeft } from "lucide-preact";
import { noticesApi } from "../../api/notices";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";

/** The works of others that the package contains, with their licences. */
export function NoticesScreen() {
  const { help, titles } = texts.value;
  const text = useLoaded("notices", () => noticesApi.text());
  return (
    <main class="screen notices-screen column gap-4">
      <div class="row middle gap-4">
        <Button icon={ArrowLeft} testId="notices-back" onPress={() => history.back()}>
          {help.notices.back}
        </Button>
        <h1>{titles.notices}</h1>
      </div>
      <Loaded of={text}>
        {(found) =>
          found ? (
            // biome-ignore lint/a11y/noNoninteractiveTabindex: a long text scrolls and has nothing else to focus
            <pre class="notices card" lang="en" tabIndex={0} data-testid="notices">
              {found}
            </pre>
          ) : (
            <p data-testid="notices-missing">{help.notices.missing}</p>
          )
        }
      </Loaded>
    </main>
  );
}
