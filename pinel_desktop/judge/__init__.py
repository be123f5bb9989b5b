"""The process that judges runs of activities, so that neither a long check nor its crash disturbs the app."""
